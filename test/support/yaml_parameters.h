// A YAML file as the parameter server holds it once roslaunch has loaded it.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <string>

#include "robot/yaml_scalar.h"
#include "robot/yaml_tree.h"

namespace cdpr_kinetostatics {

inline XmlRpc::XmlRpcValue plainParameter(const YAML::Node& node) {
  XmlRpc::XmlRpcValue value;
  if (node.IsMap()) {
    for (const auto& entry : node) value[entry.first.as<std::string>()] = plainParameter(entry.second);
    return value;
  }
  if (node.IsSequence()) {
    value.setSize(static_cast<int>(node.size()));
    for (std::size_t i = 0; i < node.size(); ++i) value[static_cast<int>(i)] = plainParameter(node[i]);
    return value;
  }
  const YamlScalar scalar = readScalar(node);
  switch (scalar.kind) {
    case YamlScalar::Kind::kFlag:
      return XmlRpc::XmlRpcValue(scalar.flag);
    case YamlScalar::Kind::kWholeNumber:
      return XmlRpc::XmlRpcValue(static_cast<int>(scalar.number));
    case YamlScalar::Kind::kNumber:
      return XmlRpc::XmlRpcValue(scalar.number);
    default:
      return XmlRpc::XmlRpcValue(scalar.text);
  }
}

inline XmlRpc::XmlRpcValue toParameter(const YAML::Node& node) { return plainParameter(plainTree(node)); }

inline XmlRpc::XmlRpcValue robotParameter(const std::string& name) {
  return toParameter(YAML::LoadFile(std::string(ROBOT_DIR) + "/" + name + ".yaml"));
}

}  // namespace cdpr_kinetostatics

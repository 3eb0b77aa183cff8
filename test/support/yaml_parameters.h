// A YAML file as the parameter server holds it, typed as rosparam does.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <string>

namespace cdpr_kinetostatics {

inline XmlRpc::XmlRpcValue toParameter(const YAML::Node& node) {
  XmlRpc::XmlRpcValue value;
  if (node.IsMap()) {
    for (const auto& entry : node) value[entry.first.as<std::string>()] = toParameter(entry.second);
    return value;
  }
  if (node.IsSequence()) {
    value.setSize(static_cast<int>(node.size()));
    for (std::size_t i = 0; i < node.size(); ++i) value[static_cast<int>(i)] = toParameter(node[i]);
    return value;
  }
  if (node.Tag() != "!" && (node.Scalar() == "true" || node.Scalar() == "false")) {
    return XmlRpc::XmlRpcValue(node.Scalar() == "true");
  }
  int integer = 0;
  double number = 0.0;
  if (YAML::convert<int>::decode(node, integer)) return XmlRpc::XmlRpcValue(integer);
  if (YAML::convert<double>::decode(node, number)) return XmlRpc::XmlRpcValue(number);
  return XmlRpc::XmlRpcValue(node.as<std::string>());
}

inline XmlRpc::XmlRpcValue robotParameter(const std::string& name) {
  return toParameter(YAML::LoadFile(std::string(ROBOT_DIR) + "/" + name + ".yaml"));
}

}  // namespace cdpr_kinetostatics

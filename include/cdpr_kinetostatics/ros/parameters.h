// The node's private parameters (config/node.yaml documents each).
#pragma once

#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace XmlRpc {
class XmlRpcValue;
}

namespace cdpr_kinetostatics {

struct NodeParameters {
  RobotDescription robot;         // ~robot, no default
  Model model = Model::kBending;  // ~model
  double tolerance = 1e-8;        // ~tolerance, relative [-]
  double timeout = 0.1;           // ~timeout, of one solve [s]
};

struct LoadedParameters {
  NodeParameters parameters;
  std::vector<std::string> warnings;  // what was ignored, and why
};

// Reads the struct of all private parameters. Throws std::invalid_argument whose text names the key, its
// value and what was expected.
LoadedParameters loadParameters(const XmlRpc::XmlRpcValue& private_parameters);

}  // namespace cdpr_kinetostatics

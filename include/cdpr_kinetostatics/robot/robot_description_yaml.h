// Reads a robot description (docs/robots.md) from YAML.
//
// The one parser for files and for the node's ~robot parameter (the ROS layer turns the latter into a
// YAML::Node). Throws std::invalid_argument whose text names the key, the value and what was expected.
#pragma once

#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"

namespace YAML {
class Node;
}

namespace cdpr_kinetostatics {

struct LoadedRobot {
  RobotDescription robot;
  std::vector<std::string> warnings;  // keys that were ignored, and why
};

LoadedRobot parseRobot(const YAML::Node& node);
LoadedRobot loadRobotFile(const std::string& path);

}  // namespace cdpr_kinetostatics

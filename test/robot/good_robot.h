// A small robot without mistakes, for tests to spoil, and what the parser says of it then.
#pragma once

#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <string>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {

inline YAML::Node goodRobot() {
  return YAML::Load(R"(
name: tester
gravity: 10
platform:
  type: rigid_body
  mass: 5
  com: [0.1, 0.2, 0.3]
  position: {xyz: [1, 2, 3], rpy: [0, 0, 0]}
  size: [0.5, 0.6, 0.7]
cable:
  axial_stiffness: 2.87e5
  bending_stiffness: 0.44
  linear_density: 0.064
  tension_min: 20
  tension_max: 5000
points:
  - {frame: [0, 0, 5], platform: [0.1, 0, 0]}
  - {frame: [4, 0, 5], platform: [-0.1, 0, 0], name: east}
  - {frame: [0, 4, 5], platform: [0, 0.1, 0]}
)");
}

// The text of the complaint about node, or "" if there was none.
inline std::string complaint(const YAML::Node& node) {
  try {
    parseRobot(node);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace cdpr_kinetostatics

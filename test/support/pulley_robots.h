// Shipped robots with guide pulleys and dead lengths, as their real winches have.
#pragma once

#include <string>

#include "robot_cases.h"

namespace cdpr_kinetostatics {

// Every second rope comes from above; dead lengths differ from cable to cable.
inline RobotDescription withPulleys(RobotDescription robot, double radius, double dead_length) {
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    CableProperties& properties = robot.cables[i].properties;
    properties.pulley = {radius, i % 2 == 0 ? RopeFrom::kBelow : RopeFrom::kAbove};
    properties.dead_length = dead_length * (1.0 + 0.1 * static_cast<double>(i));
  }
  return robot;
}

}  // namespace cdpr_kinetostatics

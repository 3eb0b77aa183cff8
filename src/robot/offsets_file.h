// The offsets of a robot's winches in a file of their own, so that what homing found survives a restart.
#pragma once

#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// In the robot's order [m]. Throws std::invalid_argument with a sentence if it is no such file, or that of another
// robot.
std::vector<double> readOffsets(const std::string& path, const RobotDescription& robot);

// As a whole or not at all: whoever reads the file meanwhile, or after a power failure, finds the old one or the new
// one. Throws std::runtime_error with a sentence.
void writeOffsets(const std::string& path, const RobotDescription& robot, const std::vector<double>& offsets);

}  // namespace cdpr_kinetostatics

// Names of measurements for people.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

// "length of cable3", "tension of cable3", "known load, force x": of those that are flagged, per cable and per
// component.
std::vector<std::string> faultNames(const RobotSolution& solution, const std::vector<bool>& lengths,
                                    const std::vector<bool>& tensions, const Eigen::Array<bool, 6, 1>& load);

// With commas between.
std::string joined(const std::vector<std::string>& names);

}  // namespace cdpr_kinetostatics

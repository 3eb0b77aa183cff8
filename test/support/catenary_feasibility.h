// Can catenaries within their tension limits hold a platform at a pose? Decided without the package's solvers: the
// textbook catenary is followed from taut to its least tension, and non-negative least squares looks for a convex
// combination of the wrenches found there that balances the load.
#pragma once

#include <optional>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {

// With this share of each cable's range left to its limits at both ends. Nothing where a cable hangs so steeply that
// its curve is not followed.
std::optional<bool> catenariesCanHold(const RobotDescription& robot, const Pose& pose, double margin);

// 6 to 12 cables, from above or all around, a platform with its centre of mass off its origin; tension_min is zero or
// up to 3 % of tension_max.
RobotDescription randomRobot(bool zero_tension_min, Dice* dice);
Pose randomPoseOf(const RobotDescription& robot, Dice* dice);

}  // namespace cdpr_kinetostatics

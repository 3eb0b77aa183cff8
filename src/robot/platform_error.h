// What the cables' rungs leave out, seen at the platform: how far it would move if the cables were the real ones.
//
// One Newton step of the finest rung from a coarser solution: each cable's force error at fixed ends
// (cable/rung_error.h) unbalances the platform, and the robot's stiffness says where that takes it
// (docs/theory.md section 5, equation (37)). An inverse solution is judged by the same number: it says how far from the
// pose asked for the platform would come to rest if the lengths were applied to the robot.
#pragma once

#include <string>
#include <vector>

#include "cable/rung_error.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

struct PlatformError {
  double translation = 0.0;  // [m]
  double rotation = 0.0;     // [rad]
  bool known = true;         // false where a cable's own estimate is not to be trusted
  std::vector<RungError> cables;
};

// Of solved cables, in the robot's order.
PlatformError platformError(const RobotDescription& robot, const Pose& pose, const std::vector<CableSolution>& cables);

// True if what the solution neglects is known to be well within accuracy [m]; a rotation counts with the platform's
// radius.
bool isWithin(const RobotDescription& robot, const RobotSolution& solution, double accuracy);

// "catenary for 6 cables, bending for 2: ...": what AUTO used and what that neglects.
std::string describeChoice(const RobotSolution& solution);

}  // namespace cdpr_kinetostatics

// What the trade is measured on: poses of a robot with their exact lengths and tensions, by BENDING at 1e-12.
#pragma once

#include <vector>

#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

constexpr double kReferenceTolerance = 1e-12;
RobotSolverOptions referenceOptions();

struct Scenario {
  InverseRequest request;   // the pose asked for; the attitude is left free where the cables cannot fix it
  RobotSolution reference;  // the pose as reached, lengths, tensions
  RobotSolution previous;   // the same 10 mm before, on the way from home
};

// At most count poses around home that the cables can hold, as far out as 5 % of the robot's span. Throws
// std::runtime_error, with a reason, if there is none.
std::vector<Scenario> scenariosFor(const RobotDescription& robot, int count);

}  // namespace cdpr_kinetostatics

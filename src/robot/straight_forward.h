// Forward kinetostatics with straight cables, half of each cable's weight at each end.
//
// STRAIGHT_ELASTIC minimises the energy of platform and springs that pull but do not push; its minimum is the
// stable pose. STRAIGHT is its limit of infinite stiffness, reached by an augmented Lagrangian. STRAIGHT with
// more cables than freedoms has no exact closure: the pose is the least-squares one, tensions are the
// non-negative ones of least norm, and the residuals say what is left.
#pragma once

#include <chrono>

#include "cdpr_kinetostatics/robot/forward.h"

namespace cdpr_kinetostatics {

RobotSolution solveStraightForward(const RobotDescription& robot, const ForwardRequest& request,
                                   const RobotSolverOptions& options, std::chrono::steady_clock::time_point deadline);

}  // namespace cdpr_kinetostatics

// From a rough seed to the reach of Newton's method.
//
// First the platform descends on straight springs to the stable pose near the seed; then Ceres' trust region
// joins the sagging cables' closure and equilibrium residuals.
#pragma once

#include <chrono>
#include <vector>

#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot/robot_forces.h"
#include "robot/search_outcome.h"

namespace cdpr_kinetostatics {

// Moves start->pose, the seed, to the stable pose on springs; forces are those of the catenary where a cable is
// slack there, and a moderate tension where it is stretched.
SearchOutcome roughStart(const RobotDescription& robot, const Wrench& external, const std::vector<double>& lengths,
                         std::chrono::steady_clock::time_point deadline, RobotForces* start);

// From state to the solution to about 1e-6, with the residual blocks of model, a catenary or a bending rung.
SearchOutcome searchBasin(const RobotDescription& robot, const Wrench& external, Model model, double tolerance,
                          std::chrono::steady_clock::time_point deadline, RobotForces* state);

}  // namespace cdpr_kinetostatics

// A robot's pose with the length and the forces of every cable: what one solver hands to the next.
#pragma once

#include <vector>

#include "cable/catenary.h"
#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot/search_outcome.h"

namespace cdpr_kinetostatics {

struct RobotForces {
  Pose pose;
  std::vector<double> lengths;    // unstrained [m], in the robot's order
  std::vector<ForcesAtA> forces;  // (H, V) of each cable
};

// How far such a state is from equilibrium with cables of this model. The closure leaves out cables that cannot be
// evaluated there, and bending ones, whose shape is no part of the state. A state that is not finite has no residuals:
// they are zero.
Residuals residualsOf(const RobotDescription& robot, const Wrench& external, Model model, const RobotForces& state);

}  // namespace cdpr_kinetostatics

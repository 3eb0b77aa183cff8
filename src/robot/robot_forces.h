// A robot's pose with the length and the forces of every cable: what one solver hands to the next.
#pragma once

#include <vector>

#include "cable/catenary.h"
#include "cdpr_kinetostatics/geometry/pose.h"

namespace cdpr_kinetostatics {

struct RobotForces {
  Pose pose;
  std::vector<double> lengths;    // unstrained [m], in the robot's order
  std::vector<ForcesAtA> forces;  // (H, V) of each cable
};

}  // namespace cdpr_kinetostatics

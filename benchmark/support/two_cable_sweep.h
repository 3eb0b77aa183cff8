// The way the paper (section 4) finds a point mass on two cables: the unknown parameters are swept, each cable being
// solved on its own, until the equilibrium equations hold.
//
// The paper does not say which parameters, nor how fine. Here: the horizontal force H, common to both cables, and V_1.
// With V_2 from the weights, equilibrium holds exactly, problem 1 (the paper's section 3.1) places the end of each
// cable, and the gap between both ends is what the sweep makes small. A grid of 5 x 5 pairs is recentred on its best
// one, and shrunk to half when that lies inside.
#pragma once

#include <Eigen/Core>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

struct SweptPoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // of the mass (x, z) [m]: the middle of the gap
  Eigen::Vector2d forces = Eigen::Vector2d::Zero();    // (H, V_1) [N]
  double tension_2 = 0.0;                              // T_A of the second cable [N]
  double gap = 0.0;                                    // [m]
  int cable_solves = 0;
};

// robot: a point mass on two cables in the world's x-z plane, the second anchor at larger x. The sweep starts around
// `around` = (H, V_1), `share` of them wide on each side, and ends when the gap is at most `gap` [m] or the grid is as
// narrow as rounding.
SweptPoint sweepForces(const RobotDescription& robot, const Eigen::Vector2d& lengths, const Eigen::Vector2d& around,
                       double share, double gap, const CableSolverOptions& options);

}  // namespace cdpr_kinetostatics

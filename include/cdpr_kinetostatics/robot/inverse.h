// Inverse kinetostatics: the platform's pose and load give unstrained lengths and tensions.
//
// Minimises sum ((T_A,i - preferred_i)/(max_i - min_i))^2 over what equilibrium and the tension limits
// leave free (docs/theory.md section 5). A pose that cannot balance within the limits is INFEASIBLE, and
// the message names the cables and limits that cannot be met.
#pragma once

#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

struct InverseRequest {
  Pose pose;
  bool free_orientation = false;  // the attitude too is left to equilibrium, pose gives its seed
  bool hold_yaw = false;          // with free_orientation: the yaw of R = Rz(yaw) Ry(pitch) Rx(roll) stays as in pose
  Wrench external_wrench = Wrench::Zero();  // on the platform, without its weight
  std::vector<double> preferred_tensions;   // at A [N]; empty: middle of the limits
};

// The lengths are in solution.cables[i].cable.length; solution.pose is the pose as reached.
RobotSolution solveInverse(const RobotDescription& robot, const InverseRequest& request,
                           const RobotSolverOptions& options);

}  // namespace cdpr_kinetostatics

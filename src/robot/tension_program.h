// One iteration of inverse kinetostatics as a quadratic program: which tensions, and which small turn of a free
// attitude, balance the platform when every cable follows its linearisation (docs/theory.md section 5, equation (36)).
#pragma once

#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/tension_distribution.h"
#include "robot/inverse_cable.h"

namespace cdpr_kinetostatics {

// A free attitude adds its rotation vector to the program's variables, behind the tensions.
struct FreeTurn {
  bool free = false;
  double weight = 0.0;  // in the objective [1/rad]
};

// The cables are linearised at the pose. Moments are divided by the robot's lever. preferred: of each tension [N].
TensionProblem tensionProgram(const RobotDescription& robot, const Pose& pose, const Wrench& external,
                              const std::vector<InverseCable>& cables, const Eigen::VectorXd& preferred,
                              const FreeTurn& turn);

}  // namespace cdpr_kinetostatics

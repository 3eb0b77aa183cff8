// Newton's method on the whole robot at once: platform pose, forces of every cable, and the nodes inside
// every bending cable converge together (docs/theory.md section 5).
//
// Each iteration linearises every cable, eliminates its (H, V), and solves for the pose with the robot's
// 6x6 stiffness (3x3 for a point mass). Quadratic near a solution, local: the start comes from elsewhere.
#pragma once

#include <chrono>
#include <vector>

#include "cdpr_kinetostatics/cable/sagging_cable.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

// The unknowns of a forward problem: the cables' lengths stay as they are.
struct CoupledState {
  Pose pose;
  std::vector<SaggingCable> cables;  // in the robot's order
};

struct CoupledOptions {
  double tolerance = 1e-8;  // forces change by less than this times the tension
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

struct CoupledOutcome {
  Status status;
  int iterations = 0;
  // Total wrench's derivative with respect to (translation, rotation vector), at fixed lengths.
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
};

CoupledOutcome solveCoupled(const RobotDescription& robot, const Wrench& external, const CoupledOptions& options,
                            CoupledState* state);

// True if no motion of the platform is unstable: the symmetric part of the stiffness is negative definite.
bool isStable(const RobotDescription& robot, const Eigen::Matrix<double, 6, 6>& stiffness);

}  // namespace cdpr_kinetostatics

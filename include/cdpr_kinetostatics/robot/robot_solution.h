// The answer of forward and inverse kinetostatics: platform, cables, and the evidence for both.
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/geometry/pose.h"

namespace cdpr_kinetostatics {

enum class Condition { kTaut = 0, kSlack = 1, kCompressed = 2 };

// COMPRESSED when H < 0; else SLACK when L exceeds the chord by more than 5 % or T_A < tension_min [N]. With a guide
// pulley L and chord are those of the free part.
Condition conditionOf(const CableSolution& cable, double tension_min);

struct RobotSolverOptions {
  Model model = Model::kBending;
  // AUTO: each cable gets the coarsest rung with which the platform stays within this of where BENDING would put it
  // [m]; for an inverse solution, if the lengths were applied.
  double accuracy = 1e-4;
  double tolerance = 1e-8;  // relative, as CableSolverOptions::tolerance
  std::chrono::duration<double> timeout{0.1};
  int profile_points = 0;          // of each cable; 0, or at least 2
  bool compute_stiffness = false;  // forward only
};

struct RobotReport {
  Status status;
  Model model = Model::kDefault;  // finest rung used
  int iterations = 0;
  int integrator_steps = 0;  // as CableSolution's, of all cables in the answer
  int evaluations = 0;
  double solve_time = 0.0;  // [s]
  // A solve that failed reports the residuals of the last state that it could evaluate; zero if there was none.
  double closure_residual = 0.0;  // largest distance of a cable's end from its attachment [m]
  double force_residual = 0.0;    // norm of the unbalanced force [N]
  double moment_residual = 0.0;   // norm of the unbalanced moment about the platform origin [N m]
  // What the models in use neglect, at the platform, to leading order (docs/theory.md section 5, equation (37)).
  double estimated_error = 0.0;           // [m]
  double estimated_rotation_error = 0.0;  // [rad]
  bool error_known = true;                // false where the estimate is an order of magnitude at best
};

struct CableResult {
  std::string name;
  Condition condition = Condition::kTaut;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();         // e_i, horizontal, from A_i to B_i, world
  Eigen::Vector3d force_on_platform = Eigen::Vector3d::Zero();  // [N], world
  CableSolution cable;                                          // in the cable's plane
  Eigen::Vector3d departure = Eigen::Vector3d::Zero();          // where the rope leaves its pulley, or A_i; world [m]
  std::vector<Eigen::Vector3d> profile;                         // of the free part, world [m]; only if asked for
};

struct RobotSolution {
  RobotReport report;
  Pose pose;
  std::vector<CableResult> cables;
  // d(total wrench about the platform origin)/d(translation, rotation vector), world axes, at fixed
  // unstrained lengths and external wrench; a point mass fills the leading 3x3 block.
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
};

// One number per cable, in the robot's order.
std::vector<double> lengthsOf(const RobotSolution& solution);   // unstrained [m]
std::vector<double> tensionsOf(const RobotSolution& solution);  // at A [N]

}  // namespace cdpr_kinetostatics

// Forward kinetostatics of a robot that moves: each solve starts from the last one.
//
// For whoever asks for many lengths that are near to each other: a simulation, a controller, a path. The pose, the
// forces and the shapes of the cables are kept, predicted for the new lengths by their derivatives, and refined by the
// coupled Newton method, usually in one or two linearisations. The answer is that of solveForward() to the tolerance
// asked for, on the branch that continues the last answer. Where that is out of reach (first call, long jump, another
// branch) solveForward() is called.
//
// AUTO keeps the cables' rungs while they are the ones that it would choose, or finer ones that it would not give up
// (robot/rung_choice.h); a change of a rung is a cold start.
//
// A warm solve does not allocate memory. One object per robot and thread; its answers depend on its history, within the
// tolerance.
#pragma once

#include <limits>
#include <vector>

#include "cdpr_kinetostatics/robot/forward.h"
#include "robot/coupled_newton.h"
#include "robot/rung_choice.h"

namespace cdpr_kinetostatics {

class ForwardFollower {
 public:
  // profile_points and compute_stiffness of the options serve solution(). The robot must outlive the object.
  ForwardFollower(const RobotDescription& robot, const RobotSolverOptions& options);

  // The request's seed serves a cold start only. After a failure the next solve is cold.
  const Status& solve(const ForwardRequest& request);

  // The last solve started from the one before.
  bool warmStarted() const { return warm_started_; }
  // Linearisations of the last solve, those of a cold start included.
  int iterations() const { return iterations_; }

  // Of the last solve, if it converged.
  const Pose& pose() const { return state_.pose; }
  const SaggingCable& cable(std::size_t i) const { return state_.cables[i]; }
  const Eigen::Matrix<double, 6, 6>& stiffness() const { return newton_.stiffness(); }

  // The last solve's answer in full, as solveForward() returns it.
  RobotSolution solution() const;

  // Makes the next solve cold.
  void forget() { can_follow_ = false; }

 private:
  bool follow(const ForwardRequest& request);
  bool converge(const Wrench& external);
  bool rungsServe();
  void startCold(const ForwardRequest& request);
  bool adopt(const RobotSolution& solution, const Wrench& external);

  const RobotDescription& robot_;
  const RobotSolverOptions options_;
  CoupledState state_;
  CoupledNewton newton_;
  std::vector<Model> rungs_;  // of the cables
  RungChoice choice_;         // AUTO
  RobotForces reached_;
  bool can_follow_ = false;
  bool warm_started_ = false;
  int iterations_ = 0;
  double solve_time_ = 0.0;
  bool has_lines_ = false;
  double contraction_ = std::numeric_limits<double>::infinity();  // a step's size over the square of the one before
  int solves_since_measured_ = 0;
  Status status_;
  Wrench external_ = Wrench::Zero();
  RobotSolution cold_;  // the answer of the last cold start
};

}  // namespace cdpr_kinetostatics

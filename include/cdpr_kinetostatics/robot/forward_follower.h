// Forward kinetostatics of a robot that moves: each solve starts from the last one.
//
// For whoever asks for many lengths that are near to each other: a simulation, a controller, a path. The pose, the
// forces and the shapes of the cables are kept, predicted for the new lengths by their derivatives, and refined by the
// coupled Newton method, usually in one or two linearisations. The answer is that of solveForward() to the tolerance
// asked for, on the branch that continues the last answer. Where that is out of reach (first call, long jump, another
// branch) the solve is cold: it costs what solveForward() costs, and gives its answer.
//
// AUTO keeps the cables' models while they are the ones that it would choose, or finer ones that it would not give up;
// a change of a model is a cold start.
//
// A warm solve does not allocate memory. One object per robot and thread; its answers depend on its history, within the
// tolerance.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "cdpr_kinetostatics/robot/forward.h"

namespace cdpr_kinetostatics {

class ForwardSolve;

class ForwardFollower {
 public:
  // profile_points and compute_stiffness of the options serve solution(). The robot must outlive the object.
  ForwardFollower(const RobotDescription& robot, const RobotSolverOptions& options);
  ~ForwardFollower();

  // The request's seed serves a cold start only; options.timeout bounds it. After a failure the next solve is cold.
  const Status& solve(const ForwardRequest& request);

  // The last solve started from the one before.
  bool warmStarted() const { return warm_started_; }
  // Iterations of the last solve: linearisations, and those of a cold start if there was one.
  int iterations() const { return iterations_; }

  // Of the last solve, if it converged. None of them allocates.
  const Pose& pose() const;
  double length(std::size_t i) const;   // unstrained length of cable i [m]
  double tension(std::size_t i) const;  // T_A of cable i [N]
  // As RobotSolution::stiffness, whether or not the options ask for it; zero by STRAIGHT.
  const Eigen::Matrix<double, 6, 6>& stiffness() const;

  // The last solve's answer in full, as solveForward() returns it.
  RobotSolution solution() const;

  // Makes the next solve cold.
  void forget() { can_follow_ = false; }

 private:
  const RobotDescription& robot_;
  const RobotSolverOptions options_;
  std::unique_ptr<ForwardSolve> solve_;
  bool checked_ = false;  // the last request was one that can be served
  bool can_follow_ = false;
  bool warm_started_ = false;
  int iterations_ = 0;
  double solve_time_ = 0.0;
  Status status_;
};

}  // namespace cdpr_kinetostatics

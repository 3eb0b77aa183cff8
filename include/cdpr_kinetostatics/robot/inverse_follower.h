// Inverse kinetostatics along a path: each solve starts from the last one.
//
// For whoever asks for many poses that are near to each other. Tensions and shapes of the cables are kept, taken to
// the new pose by their derivatives, and refined by the same sequential quadratic programming as in solveInverse(),
// whose answer this is to the tolerance asked for. Where that is out of reach (first call, long jump, free attitude,
// cables near the least tension that can hold them, other models by AUTO, limits that contradict each other) the solve
// is cold: it runs as solveInverse() does and gives the same answer, codes and sentences.
//
// One object per robot and thread; its answers depend on its history, within the tolerance.
#pragma once

#include <cstddef>
#include <memory>

#include "cdpr_kinetostatics/robot/inverse.h"

namespace cdpr_kinetostatics {

class InverseSolve;

class InverseFollower {
 public:
  // profile_points of the options serves solution(). The robot must outlive the object.
  InverseFollower(const RobotDescription& robot, const RobotSolverOptions& options);
  ~InverseFollower();

  // After a failure the next solve is cold.
  const Status& solve(const InverseRequest& request);

  // The last solve started from the one before.
  bool warmStarted() const { return warm_started_; }
  // Linearisations of the last solve, those of a cold start included.
  int iterations() const { return iterations_; }

  // Of the last solve, if it converged.
  double length(std::size_t i) const;   // unstrained length of cable i [m]
  double tension(std::size_t i) const;  // T_A of cable i [N]

  // The last solve's answer in full, as solveInverse() returns it.
  RobotSolution solution() const;

  // Makes the next solve cold.
  void forget() { can_follow_ = false; }

 private:
  const RobotDescription& robot_;
  const RobotSolverOptions options_;
  std::unique_ptr<InverseSolve> solve_;
  bool checked_ = false;  // the last request was one that can be served
  bool can_follow_ = false;
  bool warm_started_ = false;
  int iterations_ = 0;
  double solve_time_ = 0.0;
  Status status_;
};

}  // namespace cdpr_kinetostatics

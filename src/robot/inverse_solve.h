// Inverse kinetostatics by sequential quadratic programming: cables are linearised, the nearest tensions to the
// preferred ones that balance the platform within the limits are found exactly, all cables step towards them.
#pragma once

#include <chrono>
#include <vector>

#include "cable/rung_problems.h"
#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/tension_distribution.h"
#include "robot/coupled_newton.h"
#include "robot/platform_statics.h"
#include "robot/rung_choice.h"

namespace cdpr_kinetostatics {

// Cables keep this multiple of the least tension that can hold them.
constexpr double kAboveFold = 1.001;

struct InverseCable {
  SaggingCable cable;
  CablePlane plane;
  double lower = 0.0;  // limits of T_A in use [N]
  double upper = 0.0;
  // (H, V, L) change by start + by_tension * (t - T_A) + by_turn * rotation; start is by_end times what is open at B.
  Eigen::Vector3d start, by_tension;
  Eigen::Matrix<double, 3, 2> by_end;
  Eigen::Matrix3d by_turn;

  Eigen::Vector3d change(double tension, const Eigen::Vector3d& turn) const {
    return start + by_tension * (tension - cable.tensionA()) + by_turn * turn;
  }
};

// Keeps what it has found, so that the next request can start from there.
class InverseSolve {
 public:
  using Clock = std::chrono::steady_clock;

  // The robot must outlive the object.
  InverseSolve(const RobotDescription& robot, const RobotSolverOptions& options);

  // Requests are taken as checked by checkInverse(). AUTO that finds no answer tries BENDING on every cable.
  Status solve(const InverseRequest& request, Clock::time_point deadline);

  // From the last answer, which must be one. False where that leads nowhere: near folds and other branches, to other
  // rungs, with a free attitude, where limits contradict each other.
  bool follow(const InverseRequest& request);

  // The last answer.
  RobotSolution solution() const;
  const std::vector<InverseCable>& cables() const { return cables_; }
  int iterations() const { return iterations_; }

 private:
  void begin(const InverseRequest& request);
  Status run(Model model);
  RobotForces reached() const;
  Status startCables();
  void useRungs(const std::vector<Model>& rungs);
  Status iterate(double tolerance);
  Status checkBranches() const;
  bool linearise(Steps steps);
  TensionDistribution distribute();
  bool isBalanced() const;
  RungOptions roughly() const;
  bool pullBackFromFolds();
  bool raiseLimitsToFolds(const Eigen::VectorXd& tensions);
  Status contradiction(const TensionDistribution& distribution) const;
  Status unbalanced(double imbalance) const;

  bool nearFold(const InverseCable& cable, double tension) const;
  bool beyondFold(const InverseCable& cable) const;

  bool predict();
  bool converge();

  const RobotDescription& robot_;
  const RobotSolverOptions options_;
  InverseRequest request_;
  Clock::time_point deadline_;
  Pose pose_;
  bool free_turn_ = false;
  Eigen::VectorXd preferred_;
  double turn_weight_ = 0.0;
  std::vector<InverseCable> cables_;
  std::vector<Model> rungs_;  // of the cables
  RungChoice choice_;         // AUTO
  TensionDistribution distribution_;
  int iterations_ = 0;
};

// Of a request and of the options: an answer to give instead of a solution.
Status checkInverse(const RobotDescription& robot, const InverseRequest& request, const RobotSolverOptions& options);

}  // namespace cdpr_kinetostatics

// Forward kinetostatics with a memory: solves from a seed, or goes on from the last solve (docs/theory.md section 5).
//
// solveForward() uses one of these once, ForwardFollower keeps one. What is kept is the state that has converged, with
// its linearisation: pose, forces and shapes of the cables.
#pragma once

#include <chrono>
#include <limits>
#include <optional>
#include <vector>

#include "cable/tautness.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "robot/coupled_newton.h"
#include "robot/robot_forces.h"
#include "robot/rung_choice.h"
#include "robot/search_outcome.h"

namespace cdpr_kinetostatics {

class ForwardSolve {
 public:
  using Clock = std::chrono::steady_clock;

  // The robot must outlive the object.
  ForwardSolve(const RobotDescription& robot, const RobotSolverOptions& options);

  // From the request's seed, or from the robot's home. Requests are taken as checked by checkForward().
  const Status& solve(const ForwardRequest& request, Clock::time_point deadline);

  // From the last answer, which must be one. False where that leads nowhere: over a long jump, onto another branch, to
  // other models by AUTO, past a slack straight cable. Only solve() can go on from there.
  bool follow(const ForwardRequest& request);

  // The last answer in full, verified; where only an unstable pose was found, that; or what a search that failed had
  // reached.
  RobotSolution solution() const;

  // Of the last answer.
  const Pose& pose() const { return state_.pose; }
  double length(std::size_t i) const { return request_.lengths[i]; }  // unstrained [m]
  double tension(std::size_t i) const;                                // at A [N]
  const Eigen::Matrix<double, 6, 6>& stiffness() const;

  // Of the last call: iterations of all stages of solve(), or linearisations of follow().
  int iterations() const { return outcome_.iterations; }

 private:
  // A stage of solve() leaves how it ended in outcome_, with the iterations of all stages so far. True if it succeeded.
  bool solveOnLines(Model model);
  bool solveOnCables();
  bool reachCatenaries(RobotForces* start);
  bool skipSearch(Model rung, RobotForces* start);
  void chooseRungs(const RobotForces& start);
  bool refine(const RobotForces& start, int max_iterations = CoupledOptions().max_iterations,
              double own_shape = kHangingExcess);
  bool judge();
  bool isLost() const;
  void stiffenFrom(const Pose& pose);
  void searchBending(RobotForces start);
  bool took(const SearchOutcome& stage);
  void goBackTo(const SearchOutcome& stage);

  void startCables(const RobotForces& start, double own_shape);
  RobotSolution assembled() const;
  RobotSolution verified(RobotSolution solution) const;

  bool onLines() const { return state_.cables.empty(); }
  bool takeUpLines();
  bool converge(const Wrench& external);
  bool rungsServe();

  const RobotDescription& robot_;
  const RobotSolverOptions options_;
  ForwardRequest request_;
  Clock::time_point deadline_;
  SearchOutcome outcome_;
  // Straight cables are solved by springs and have no cables in the state until a path goes on from them.
  CoupledState state_;
  CoupledNewton newton_;
  std::vector<Model> rungs_;               // of the cables
  std::optional<RobotSolution> answer_;    // the last answer, where a stage has needed it in full
  std::optional<RobotSolution> unstable_;  // the last pose that a stage of solve() found to be unstable
  Eigen::Matrix<double, 6, 6> lines_stiffness_ = Eigen::Matrix<double, 6, 6>::Zero();

  RungChoice choice_;    // AUTO
  RobotForces reached_;  // a workspace
  // Newton's method leaves this times a step's square (see converge()).
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();
  double contraction_ = kUnknown;
  int solves_since_measured_ = 0;
};

// Of a request and of the options: an answer to give instead of a solution.
Status checkForward(const RobotDescription& robot, const ForwardRequest& request, const RobotSolverOptions& options);

}  // namespace cdpr_kinetostatics

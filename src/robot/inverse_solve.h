// Inverse kinetostatics by sequential quadratic programming: cables are linearised, the nearest tensions to the
// preferred ones that balance the platform within the limits are found exactly, all cables step towards them
// (docs/theory.md section 5, equation (36)).
//
// solveInverse() uses one of these once, InverseFollower keeps one and goes on from its last answer.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot/inverse_iteration.h"
#include "robot/linear_robot.h"
#include "robot/platform_stability.h"
#include "robot/rung_choice.h"
#include "robot/search_outcome.h"

namespace cdpr_kinetostatics {

class InverseSolve {
 public:
  using Clock = std::chrono::steady_clock;

  // The robot must outlive the object.
  InverseSolve(const RobotDescription& robot, const RobotSolverOptions& options);

  // Requests are taken as checked by checkInverse(). AUTO that finds no answer tries BENDING on every cable; a free
  // attitude that is not found, or is unstable, from the one asked for is looked for from others.
  const Status& solve(const InverseRequest& request, Clock::time_point deadline);

  // From the last answer, which must be one. False where that leads nowhere: near folds and other branches, to other
  // models by AUTO, with a free attitude, where limits contradict each other.
  bool follow(const InverseRequest& request);

  // How the last call ended.
  const Status& status() const { return outcome_.status; }

  // The last answer in full, or what a search that failed had reached.
  RobotSolution solution() const;

  // Of the last answer.
  double length(std::size_t i) const { return iteration_.cables()[i].cable.length(); }     // unstrained [m]
  double tension(std::size_t i) const { return iteration_.cables()[i].cable.tensionA(); }  // at A [N]

  // Linearisations of the last call.
  int iterations() const { return outcome_.iterations; }

 private:
  // From this attitude, in full.
  Status attempt(const Eigen::Quaterniond& attitude);
  Status run(Model model);
  Status iterate(double tolerance);
  Status settle(double tolerance);
  Status checkBranches() const;
  Status noStiffness() const;
  Status judge();

  // A free attitude from elsewhere, after the attempt from the attitude asked for has ended like this.
  Status searchAttitudes(const Status& first);
  // To where an unstable platform would go with its lengths.
  std::optional<Eigen::Quaterniond> attitudeAfterFall();
  // Along the line from home to the position, each solve from the attitude before.
  std::optional<Eigen::Quaterniond> attitudeFromHome();
  bool isLate() const { return Clock::now() > deadline_; }

  bool predict();
  bool converge();
  const LinearRobot::Stiffness& stiffness();

  const RobotDescription& robot_;
  const RobotSolverOptions options_;
  InverseRequest request_;
  Clock::time_point deadline_;
  InverseIteration iteration_;
  LinearRobot linear_;
  std::vector<Model> rungs_;  // of the cables
  RungChoice choice_;         // AUTO
  SearchOutcome outcome_;
};

// Of a request and of the options: an answer to give instead of a solution.
Status checkInverse(const RobotDescription& robot, const InverseRequest& request, const RobotSolverOptions& options);

}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/robot/inverse_follower.h"

#include <chrono>

#include "robot/inverse_solve.h"
#include "robot/robot_checks.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {

InverseFollower::InverseFollower(const RobotDescription& robot, const RobotSolverOptions& options)
    : robot_(robot), options_(options), solve_(new InverseSolve(robot, options)) {}

InverseFollower::~InverseFollower() = default;

const Status& InverseFollower::solve(const InverseRequest& request) {
  const InverseSolve::Clock::time_point begin = InverseSolve::Clock::now();
  status_ = checkInverse(robot_, request, options_);
  if (!can_follow_) status_ = firstRefusal(checkRobot(robot_), status_);  // a robot that was solved has been checked
  checked_ = status_.ok();
  warm_started_ = checked_ && can_follow_ && solve_->follow(request);
  if (warm_started_) status_ = solve_->status();
  iterations_ = checked_ && can_follow_ ? solve_->iterations() : 0;
  if (checked_ && !warm_started_) {
    status_ = solve_->solve(request, deadlineAfter(options_.timeout));
    iterations_ += solve_->iterations();
  }
  can_follow_ = status_.ok();
  solve_time_ = std::chrono::duration<double>(InverseSolve::Clock::now() - begin).count();
  return status_;
}

double InverseFollower::length(std::size_t i) const { return solve_->length(i); }

double InverseFollower::tension(std::size_t i) const { return solve_->tension(i); }

RobotSolution InverseFollower::solution() const {
  RobotSolution solution = checked_ ? solve_->solution() : refusedRobot(options_.model, status_);
  solution.report.solve_time = solve_time_;
  return solution;
}

}  // namespace cdpr_kinetostatics

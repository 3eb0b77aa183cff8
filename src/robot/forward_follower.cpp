#include "cdpr_kinetostatics/robot/forward_follower.h"

#include <chrono>

#include "robot/forward_solve.h"
#include "robot/robot_checks.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {

ForwardFollower::ForwardFollower(const RobotDescription& robot, const RobotSolverOptions& options)
    : robot_(robot), options_(options), solve_(new ForwardSolve(robot, options)) {}

ForwardFollower::~ForwardFollower() = default;

const Status& ForwardFollower::solve(const ForwardRequest& request) {
  const ForwardSolve::Clock::time_point begin = ForwardSolve::Clock::now();
  status_ = checkForward(robot_, request, options_);
  if (!can_follow_) status_ = firstRefusal(checkRobot(robot_), status_);  // a robot that was solved has been checked
  checked_ = status_.ok();
  warm_started_ = checked_ && can_follow_ && solve_->follow(request);
  iterations_ = checked_ && can_follow_ ? solve_->iterations() : 0;
  if (checked_ && !warm_started_) {
    status_ = solve_->solve(request, deadlineAfter(options_.timeout));
    iterations_ += solve_->iterations();
  }
  can_follow_ = status_.ok();
  solve_time_ = std::chrono::duration<double>(ForwardSolve::Clock::now() - begin).count();
  return status_;
}

const Pose& ForwardFollower::pose() const { return solve_->pose(); }

double ForwardFollower::length(std::size_t i) const { return solve_->length(i); }

double ForwardFollower::tension(std::size_t i) const { return solve_->tension(i); }

const Eigen::Matrix<double, 6, 6>& ForwardFollower::stiffness() const { return solve_->stiffness(); }

RobotSolution ForwardFollower::solution() const {
  RobotSolution solution = checked_ ? solve_->solution() : refusedRobot(options_.model, status_);
  solution.report.solve_time = solve_time_;
  return solution;
}

}  // namespace cdpr_kinetostatics

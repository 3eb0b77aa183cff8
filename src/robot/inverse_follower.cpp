#include "cdpr_kinetostatics/robot/inverse_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/inverse_solve.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {
namespace {

// A prediction that changes forces or lengths by more than this share is a jump: it starts cold.
constexpr double kLongestReach = 0.5;

// More linearisations than this are no gain.
constexpr int kMostLinearisations = 8;

}  // namespace

bool InverseSolve::follow(const InverseRequest& request) {
  begin(request);
  if (free_turn_) return false;
  for (std::size_t i = 0; i < cables_.size(); ++i) cables_[i].lower = robot_.cables[i].tension_min;
  if (!predict() || !converge() || !checkBranches().ok()) return false;
  return options_.model != Model::kAuto || choice_.serve(robot_, reached(), options_.accuracy, rungs_);
}

// The cables follow the platform at constant tension.
bool InverseSolve::predict() {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    InverseCable& c = cables_[i];
    const CablePlane plane = cablePlane(robot_.cables[i], pose_);
    const Eigen::Vector3d change = c.by_end * Eigen::Vector2d(plane.x - c.plane.x, plane.y - c.plane.y);
    const double size = std::max(change.head<2>().norm() / c.cable.tensionA(), std::abs(change.z()) / c.cable.length());
    if (!(size < kLongestReach)) return false;
    c.cable.follow(change);
  }
  return true;
}

bool InverseSolve::converge() {
  double last_size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostLinearisations; ++i) {
    ++iterations_;
    if (!linearise(Steps::kNewWhereDue)) return false;
    distribution_ = distribute();
    if (!distribution_.feasible || !isBalanced()) return false;
    double size = 0.0;
    for (std::size_t k = 0; k < cables_.size(); ++k) {
      const InverseCable& c = cables_[k];
      const double tension = distribution_.tensions(static_cast<Eigen::Index>(k));
      const Eigen::Vector3d change = c.change(tension, Eigen::Vector3d::Zero());
      if (beyondFold(c) || nearFold(c, tension) || !change.allFinite() || c.cable.dampingFor(change) < 1.0)
        return false;
      size = std::max({size, change.head<2>().norm() / c.cable.tensionA(), std::abs(change.z()) / c.cable.length(),
                       c.cable.angleChange(change)});
    }
    for (std::size_t k = 0; k < cables_.size(); ++k) {
      InverseCable& c = cables_[k];
      c.cable.step(c.change(distribution_.tensions(static_cast<Eigen::Index>(k)), Eigen::Vector3d::Zero()), 1.0);
    }
    if (size <= options_.tolerance || (size < 1e-6 && size >= 0.5 * last_size)) return true;
    last_size = size;
  }
  return false;
}

InverseFollower::InverseFollower(const RobotDescription& robot, const RobotSolverOptions& options)
    : robot_(robot), options_(options), solve_(new InverseSolve(robot, options)) {}

InverseFollower::~InverseFollower() = default;

const Status& InverseFollower::solve(const InverseRequest& request) {
  const InverseSolve::Clock::time_point begin = InverseSolve::Clock::now();
  status_ = checkInverse(robot_, request, options_);
  warm_started_ = status_.ok() && can_follow_ && solve_->follow(request);
  if (status_.ok() && !warm_started_) {
    status_ = solve_->solve(request, deadlineAfter(options_.timeout));
  }
  can_follow_ = status_.ok();
  solve_time_ = std::chrono::duration<double>(InverseSolve::Clock::now() - begin).count();
  return status_;
}

int InverseFollower::iterations() const { return solve_->iterations(); }

const SaggingCable& InverseFollower::cable(std::size_t i) const { return solve_->cables()[i].cable; }

RobotSolution InverseFollower::solution() const {
  RobotSolution solution = status_.ok() ? solve_->solution() : refusedRobot(options_.model, status_);
  solution.report.solve_time = solve_time_;
  return solution;
}

}  // namespace cdpr_kinetostatics

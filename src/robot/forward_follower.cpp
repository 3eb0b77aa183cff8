#include "cdpr_kinetostatics/robot/forward_follower.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "robot/platform_error.h"
#include "robot/robot_checks.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {
namespace {

// A prediction that changes forces, angles or the pose by more than this share is a jump: it starts cold.
constexpr double kLongestReach = 0.5;

// Newton's method that takes more linearisations than this is lost.
constexpr int kMostLinearisations = 8;

// What is left after a step of Newton's method is that step's size squared times a number that changes slowly along a
// path. It is measured where a solve takes two steps, and trusted with so much in hand, for so many solves.
constexpr double kSafety = 100.0;
constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr int kSolvesBetweenMeasurements = 10;

}  // namespace

ForwardFollower::ForwardFollower(const RobotDescription& robot, const RobotSolverOptions& options)
    : robot_(robot), options_(options), newton_(robot) {}

const Status& ForwardFollower::solve(const ForwardRequest& request) {
  const auto begin = std::chrono::steady_clock::now();
  iterations_ = 0;
  warm_started_ = can_follow_ && follow(request);
  if (warm_started_) {
    status_.code = Code::kConverged;
    status_.message.clear();
  } else {
    startCold(request);
  }
  external_ = request.external_wrench;
  solve_time_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return status_;
}

bool ForwardFollower::follow(const ForwardRequest& request) {
  if (request.lengths.size() != state_.cables.size() || !checkWrench(robot_, request.external_wrench).ok())
    return false;
  for (const double length : request.lengths) {
    if (!(length > 0.0)) return false;
  }
  if (!(newton_.predict(request.lengths, request.external_wrench, &state_) < kLongestReach)) return false;
  return converge(request.external_wrench) && isOnBranch(robot_, newton_.stiffness(), state_) && rungsServe();
}

// From a state near the solution. Integration steps are chosen anew where the old ones do not serve.
bool ForwardFollower::converge(const Wrench& external) {
  if (++solves_since_measured_ > kSolvesBetweenMeasurements) contraction_ = kUnknown;
  double last_size = 0.0;
  for (int i = 0; i < kMostLinearisations; ++i) {
    ++iterations_;
    if (!newton_.linearise(external, Steps::kNewWhereDue, &state_) || !newton_.solve()) return false;
    const double size = newton_.size(state_);
    if (i > 0) {
      if (!(size < last_size)) return size < 1e-5 && newton_.atRounding();
      // A straight cable's stiffness is nearly all along it: its steps contract now by the one, now by the other.
      contraction_ = has_lines_ ? kUnknown : size / (last_size * last_size);
      solves_since_measured_ = 0;
    }
    newton_.step(&state_);
    if (size <= options_.tolerance || kSafety * contraction_ * size * size <= options_.tolerance) return true;
    last_size = size;
  }
  return false;
}

bool ForwardFollower::rungsServe() {
  if (options_.model != Model::kAuto) return true;
  readForces(state_, &reached_);
  return choice_.serve(robot_, reached_, options_.accuracy, rungs_);
}

void ForwardFollower::startCold(const ForwardRequest& request) {
  cold_ = solveForward(robot_, request, options_);
  iterations_ += cold_.report.iterations;
  status_ = cold_.report.status;
  can_follow_ = status_.ok() && cold_.report.model != Model::kStraight && adopt(cold_, request.external_wrench);
}

// Takes a solution up as the state to follow.
bool ForwardFollower::adopt(const RobotSolution& solution, const Wrench& external) {
  state_.pose = solution.pose;
  state_.cables.clear();
  rungs_.clear();
  has_lines_ = false;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CableSolution& cable = solution.cables[i].cable;
    rungs_.push_back(cable.model);
    has_lines_ = has_lines_ || isStraight(cable.model);
    state_.cables.emplace_back(robot_.cables[i].properties, cable.model, options_.tolerance);
    SaggingCable& adopted = state_.cables.back();
    const SolveLimits bending{options_.tolerance};
    if (!adopted.startBetween(cable.length, cable.x, cable.y, bending).ok()) return false;
  }
  return converge(external) && isOnBranch(robot_, newton_.stiffness(), state_);
}

RobotSolution ForwardFollower::solution() const {
  if (!warm_started_) return cold_;
  RobotSolution solution;
  solution.pose = state_.pose;
  solution.report.status = status_;
  solution.report.iterations = iterations_;
  solution.report.solve_time = solve_time_;
  assemble(robot_, external_, describeCables(robot_, state_.pose, state_.cables, options_.profile_points), &solution);
  if (options_.model == Model::kAuto) solution.report.status.message = describeChoice(solution);
  if (options_.compute_stiffness) solution.stiffness = newton_.stiffness();
  return solution;
}

}  // namespace cdpr_kinetostatics

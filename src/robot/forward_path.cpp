// ForwardSolve along a path: from the last answer to the next.
#include <algorithm>
#include <cmath>

#include "cable/iteration_schedule.h"
#include "robot/forward_solve.h"
#include "robot/platform_stability.h"

namespace cdpr_kinetostatics {
namespace {

// A prediction along a path that changes forces, angles or the pose by more than this share is a jump.
constexpr double kLongestReach = 0.5;

// Along a path, Newton's method that takes more linearisations than this is lost.
constexpr int kMostLinearisations = 8;

// What is left after a step of Newton's method is that step's size squared times a number that changes slowly along a
// path. It is measured where a solve takes two steps, and trusted with so much in hand, for so many solves.
constexpr double kSafety = 100.0;
constexpr int kSolvesBetweenMeasurements = 10;

}  // namespace

bool ForwardSolve::follow(const ForwardRequest& request) {
  outcome_.iterations = 0;
  if (onLines() && !takeUpLines()) return false;
  if (!(newton_.predict(request.lengths, request.external_wrench, &state_) < kLongestReach)) return false;
  if (!converge(request.external_wrench)) return false;
  const PlatformStability stability = platformStability(robot_, newton_.stiffness());
  if (!isOnBranch(stability, state_) || !rungsServe()) return false;
  request_ = request;
  outcome_.status = describeStability(robot_, stability);
  answer_.reset();
  return true;
}

// Gives the state its cables, each under the force of its line. False where a line is slack, and where lines have no
// stiffness: STRAIGHT.
bool ForwardSolve::takeUpLines() {
  if (rungs_.front() != Model::kStraightElastic) return false;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    SaggingCable cable(robot_.cables[i].properties, rungs_[i], options_.tolerance);
    const CablePlane plane = cablePlane(robot_.cables[i], state_.pose);
    if (!cable.startBetween(request_.lengths[i], plane.x, plane.y, {options_.tolerance}).ok()) {
      state_.cables.clear();
      return false;
    }
    state_.cables.push_back(std::move(cable));
  }
  return converge(request_.external_wrench) && isOnBranch(platformStability(robot_, newton_.stiffness()), state_);
}

// From a state near the solution. Integration steps are chosen anew where the old ones do not serve.
bool ForwardSolve::converge(const Wrench& external) {
  // A straight cable's stiffness is nearly all along it: its steps contract now by the one, now by the other.
  const bool measurable = !std::any_of(rungs_.begin(), rungs_.end(), isStraight);
  if (++solves_since_measured_ > kSolvesBetweenMeasurements) contraction_ = kUnknown;
  double last_size = 0.0;
  for (int i = 0; i < kMostLinearisations; ++i) {
    ++outcome_.iterations;
    if (!newton_.linearise(external, Steps::kNewWhereDue, &state_) || !newton_.solve()) return false;
    const double size = newton_.size(state_);
    if (i > 0) {
      if (!(size < last_size)) return size < kRoundingSize && newton_.atRounding();
      contraction_ = measurable ? size / (last_size * last_size) : kUnknown;
      solves_since_measured_ = 0;
    }
    newton_.step(&state_);
    if (size <= options_.tolerance || kSafety * contraction_ * size * size <= options_.tolerance) return true;
    last_size = size;
  }
  return false;
}

bool ForwardSolve::rungsServe() {
  if (options_.model != Model::kAuto) return true;
  readForces(state_, &reached_);
  return choice_.serve(robot_, reached_, options_.accuracy, rungs_);
}

}  // namespace cdpr_kinetostatics

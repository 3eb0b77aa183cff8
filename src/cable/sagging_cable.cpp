#include "cable/sagging_cable.h"

#include <algorithm>
#include <cmath>

#include "cable/bending_expansion.h"
#include "cable/cable_evaluation.h"
#include "cable/straight.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kMaxAngleStep = 0.7;   // [rad]
constexpr double kMaxLengthStep = 0.1;  // share of the length

// The forces of a taut cable change at most by this share in one step: its sag goes with 1/T^2.
constexpr double kMaxForceStep = 1.0;
constexpr double kTautExcess = 1.01;

// A catenary's horizontal force never falls to less than this share in one step: at zero it has a fold.
constexpr double kLeastShare = 0.2;

}  // namespace

SaggingCable::SaggingCable(const CableProperties& cable, Model model, double tolerance)
    : seen_(asSeenBy(model, cable)), model_(model), tolerance_(tolerance) {}

void SaggingCable::start(double length, const ForcesAtA& forces) {
  length_ = length;
  forces_ = forces;
  if (bends()) shooting_.start(seen_, length, forces.horizontal, forces.vertical, tolerance_);
}

Status SaggingCable::startBetween(double length, double x, double y, const SolveLimits& options) {
  length_ = length;
  if (bends()) {
    const BendingOutcome outcome = solveBendingForces(seen_, length, x, y, options, &shooting_);
    forces_ = {shooting_.horizontalForce(), shooting_.verticalForceA()};
    return outcome.status;
  }
  if (isStraight(model_)) {
    if (std::hypot(x, y) <= length) return {Code::kInfeasible, "the straight cable is slack"};
    forces_ = straightForces(seen_, length, x, y);
    return {Code::kConverged, ""};
  }
  const std::optional<ForcesAtA> catenary = correctedCatenaryForces(seen_, length, x, y);
  if (!catenary) return {Code::kInfeasible, "the cable cannot span its ends"};
  forces_ = *catenary;
  return {Code::kConverged, ""};
}

bool SaggingCable::linearise(bool adapt) {
  if (bends()) {
    if (!shooting_.linearise(adapt)) return false;
    end_ = shooting_.end();
    return true;
  }
  end_ = isStraight(model_) ? straightEnd(seen_, forces_.horizontal, forces_.vertical, length_)
                            : correctedCatenaryEnd(seen_, forces_.horizontal, forces_.vertical, length_);
  return end_.position.allFinite() && end_.jacobian.allFinite();
}

double SaggingCable::dampingFor(const Eigen::Vector3d& change) const {
  double damping = 1.0;
  if (std::abs(change.z()) > kMaxLengthStep * length_) damping = kMaxLengthStep * length_ / std::abs(change.z());
  if (bends()) damping = std::min(damping, kMaxAngleStep / shooting_.angleChange(change));
  if (!bends() || length_ < kTautExcess * end_.position.norm()) {
    damping = std::min(damping, kMaxForceStep * tensionA() / change.head<2>().norm());
  }
  if (bends()) return damping;
  const double h = forces_.horizontal;
  if (h > 0.0 && h + change.x() < kLeastShare * h) damping = std::min(damping, (kLeastShare - 1.0) * h / change.x());
  return damping;
}

double SaggingCable::angleChange(const Eigen::Vector3d& change) const {
  return bends() ? shooting_.angleChange(change) : 0.0;
}

void SaggingCable::step(const Eigen::Vector3d& change, double damping) {
  forces_.horizontal += damping * change.x();
  forces_.vertical += damping * change.y();
  length_ += damping * change.z();
  if (bends()) shooting_.step(change, damping);
}

void SaggingCable::follow(const Eigen::Vector3d& change) {
  forces_.horizontal += change.x();
  forces_.vertical += change.y();
  length_ += change.z();
  if (bends()) shooting_.follow(change);
}

bool SaggingCable::stepsFit() { return !bends() || shooting_.stepsFit(); }

bool SaggingCable::onBranch() const { return bends() ? onSaggingBranch(shooting_) : !pushes(); }

double SaggingCable::tensionA() const { return std::hypot(forces_.horizontal, forces_.vertical); }

CableSolution SaggingCable::describe(double x, double y, int profile_points) const {
  if (!bends()) {
    return describeClosedForm(seen_, model_, length_, forces_.horizontal, forces_.vertical, x, y, profile_points);
  }
  CableSolution solution = describeBending(seen_, model_, shooting_, profile_points);
  solution.closure_residual = std::hypot(solution.x - x, solution.y - y);
  return solution;
}

}  // namespace cdpr_kinetostatics

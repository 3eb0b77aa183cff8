#include "cable/closed_form_cable.h"

#include <algorithm>

#include "cable/step_limits.h"

namespace cdpr_kinetostatics {
namespace {

// The horizontal force never falls to less than this share in one step: at zero the end has a fold.
constexpr double kLeastShare = 0.2;

}  // namespace

void ClosedFormCable::start(double length, const ForcesAtA& forces) {
  length_ = length;
  forces_ = forces;
}

double ClosedFormCable::dampingFor(const Eigen::Vector3d& change) const {
  double damping = std::min(dampingByLength(change, length_), dampingByForce(change, forces_.tension()));
  const double h = forces_.horizontal;
  if (h > 0.0 && h + change.x() < kLeastShare * h) damping = std::min(damping, (kLeastShare - 1.0) * h / change.x());
  return damping;
}

void ClosedFormCable::step(const Eigen::Vector3d& change, double damping) {
  forces_.horizontal += damping * change.x();
  forces_.vertical += damping * change.y();
  length_ += damping * change.z();
}

bool ClosedFormCable::setEnd(const EndPoint& end) {
  end_ = end;
  return end_.position.allFinite() && end_.jacobian.allFinite();
}

}  // namespace cdpr_kinetostatics

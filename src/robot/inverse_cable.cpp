#include "robot/inverse_cable.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cable/tautness.h"
#include "robot/platform_statics.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
namespace {

// Step of the differences behind second derivatives, relative to the tension: their error and their rounding are alike
// there, and both far below what Newton's method on them notices.
constexpr double kDifference = 1e-5;

// In one step the pull falls by no more than this share of what it is above that of an endless cable: beyond the fold a
// linearisation says nothing.
constexpr double kMostRelease = 0.7;

// A cable that bends can push, with no more than this many times the load under which a bar of its chord's length
// buckles.
constexpr double kBuckling = 2.0;

// A cable is closed where its own step is below this, relative; a bending one where the next linearisation, which
// every iteration takes in any case, closes it.
constexpr double kClosed = 1e-14;
constexpr double kClosedToRounding = 1e-9;
constexpr double kNearlyClosed = 1e-2;
constexpr int kMostSteps = 40;

// Derivatives of (H, V, L) with respect to the end (x, y) and to the pull: rows of the inverted system are closure and
// the pull, H cos + (q L/2 - V) sin of the chord's slope; with a pulley L and chord are those of the free part.
Eigen::Matrix3d byEndAndPull(const SaggingCable& cable, const Eigen::Vector2d& along) {
  Eigen::Matrix3d system;
  const Eigen::RowVector3d weight = Eigen::RowVector3d::UnitY() - cable.verticalForceBDerivative();
  system << cable.end().jacobian, Eigen::RowVector3d(along.x(), -along.y(), 0.0) + 0.5 * weight * along.y();
  return system.inverse();
}

}  // namespace

bool InverseCable::linearise(const CableDescription& description, const Pose& pose, Steps steps, double taut) {
  const bool adapt = steps == Steps::kNew || (steps == Steps::kNewWhereDue && !cable.stepsFit());
  if (!cable.linearise(adapt)) return false;
  plane = cablePlane(description, pose);
  const Eigen::Vector2d end(plane.x, plane.y);
  const Eigen::Vector2d free = straightFreePart(cable.properties(), plane.x, plane.y);
  chord = free.norm();
  along = free / chord;
  const double cosine = along.x();
  const double sine = along.y();
  const Eigen::Vector2d forces(cable.horizontalForce(), cable.verticalForceA());
  const double half_weight = 0.5 * cable.properties().weight * cable.freeLength();
  const Eigen::Matrix3d inverse = byEndAndPull(cable, along);
  const Eigen::Vector2d defect = end - cable.end().position;
  open = defect.norm();
  pull = cosine * forces.x() + sine * (half_weight - forces.y());
  by_pull = inverse.col(2);
  start = inverse.leftCols<2>() * defect;
  // As the end moves across the chord, the chord turns, and with it the component of the force that is the pull.
  const double across = cosine * (half_weight - forces.y()) - sine * forces.x();
  by_end = inverse.leftCols<2>() - by_pull * (across / chord) * Eigen::RowVector2d(-sine, cosine);
  const Eigen::Vector2d closed = forces + start.head<2>();
  tension = closed.norm();
  slope = closed.dot(by_pull.head<2>()) / tension;
  if (!inverse.allFinite() || !std::isfinite(slope) || !measureCurvature(taut)) return false;
  limitPull();
  return true;
}

// By differences of the tangent on the closed cables' curve. What is still open in a bending cable changes its tangent
// by more than the step does, so there the difference is taken between two cables that have both been closed by one
// step.
bool InverseCable::measureCurvature(double taut) {
  curvature = 0.0;
  bend.setZero();
  if (slope >= taut) return true;
  const double step = kDifference * tension / by_pull.head<2>().norm();
  Tangent more, less{by_pull, slope};
  if (!tangentBeside(step, &more)) return false;
  if (cable.bends() && !tangentBeside(-step, &less)) return false;
  const double distance = cable.bends() ? 2.0 * step : step;
  bend = (more.by_pull - less.by_pull) / distance;
  curvature = std::max(0.0, (more.slope - less.slope) / distance);
  return bend.allFinite() && std::isfinite(curvature);
}

bool InverseCable::tangentBeside(double change_of_pull, Tangent* tangent) const {
  SaggingCable beside = cable;
  beside.step(start + by_pull * change_of_pull, 1.0);
  if (!beside.linearise(false)) return false;
  tangent->by_pull = byEndAndPull(beside, along).col(2);
  const Eigen::Vector2d forces(beside.horizontalForce(), beside.verticalForceA());
  tangent->slope = forces.dot(tangent->by_pull.head<2>()) / forces.norm();
  return true;
}

void InverseCable::limitPull() {
  // The root of tension + slope d + curvature d^2/2 = limit on the taut side of the parabola's least tension.
  const auto changeTo = [this](double limit, bool* exists) {
    const double square = slope * slope + 2.0 * curvature * (limit - tension);
    *exists = square >= 0.0 && slope + std::sqrt(square) > 0.0;
    if (*exists) return 2.0 * (limit - tension) / (slope + std::sqrt(square));
    return curvature > 0.0 ? -slope / curvature : 0.0;
  };
  bool exists = false;
  least = pull + changeTo(lower, &exists);
  at_fold = !exists;
  most = pull + changeTo(upper, &exists);
  too_heavy = !exists && curvature > 0.0;
  const double h = cable.horizontalForce() + start.x();
  // A cable that pushes satisfies no positive tension_min.
  if (cable.bends() && lower > 0.0 && by_pull.x() > 0.0) least = std::max(least, pull - h / by_pull.x());
  least = std::max(least, pull - kMostRelease * std::abs(pull - pullOfEndless()));
  most = std::max(most, least);
}

double InverseCable::pullOfEndless() const {
  if (isStraight(cable.model())) return 0.0;
  const double height = straightFreePart(cable.properties(), plane.x, plane.y).y();
  const double hanging = 0.5 * cable.properties().weight * height * height / chord;
  if (!cable.bends()) return hanging;
  return hanging - kBuckling * bucklingForce(cable.properties(), chord);
}

bool InverseCable::close(const CableDescription& description, const Pose& pose, Steps steps, double new_pull,
                         const Eigen::Vector3d& turn) {
  Eigen::Vector3d step = change(std::clamp(new_pull, least, most), turn);
  double last_size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostSteps && step.allFinite(); ++i) {
    cable.step(step, cable.dampingFor(step));
    if (!linearise(description, pose, steps, kTautInSearch)) return false;
    step = change(std::clamp(new_pull, least, most));
    const double left = std::max(size(step), cable.angleChange(step));
    if (cable.bends() ? left < kNearlyClosed
                      : left < kClosed || (left < kClosedToRounding && left >= 0.5 * last_size)) {
      return true;
    }
    last_size = left;
  }
  return false;
}

double InverseCable::beyondLimits() const { return std::max({0.0, least - pull, pull - most}); }

double InverseCable::size(const Eigen::Vector3d& change) const {
  return std::max(change.head<2>().norm() / tension, std::abs(change.z()) / cable.length());
}

Eigen::Matrix3d InverseCable::byTurn() const { return by_end * plane.toPlane() * -cross(plane.arm); }

Eigen::RowVector3d InverseCable::tensionByTurn() const {
  const Eigen::Vector2d closed(cable.horizontalForce() + start.x(), cable.verticalForceA() + start.y());
  return closed.transpose() / tension * byTurn().topRows<2>();
}

Eigen::Vector3d InverseCable::force() const { return forceAtB(plane, cable.horizontalForce(), cable.verticalForceB()); }

Eigen::Matrix3d InverseCable::forceByCable() const {
  return -plane.direction * Eigen::RowVector3d::UnitX() + Eigen::Vector3d::UnitZ() * cable.verticalForceBDerivative();
}

}  // namespace cdpr_kinetostatics

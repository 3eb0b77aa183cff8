#include "cable/corrected_catenary_cable.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "cable/bending_expansion.h"
#include "cable/catenary.h"
#include "cable/catenary_cable.h"

namespace cdpr_kinetostatics {
namespace {

// Newton's method starts nearby: it takes three or four.
constexpr int kMaxIterations = 30;

// A step of the forces [share of T_A] below the first is rounding; one below the second that no longer shrinks is, too.
constexpr double kRoundingStep = 1e-15;
constexpr double kSmallStep = 1e-7;

// An effect that moves the end by more than the cable is long is none of first order: next to the vertical, where a
// slack catenary has no width, (24) goes with 1/H^3 beyond all bounds.
// The same holds for the layer at an end that turns it by more than a radian.
bool isFirstOrder(const CableProperties& cable, double length, const ForcesAtA& forces) {
  const auto turnOfLayer = [&](double vertical) {
    const double tension = std::hypot(forces.horizontal, vertical);
    return cable.weight * forces.horizontal / (tension * tension) * std::sqrt(cable.bending_stiffness / tension);
  };
  const double turn = std::max(turnOfLayer(forces.vertical), turnOfLayer(forces.vertical - cable.weight * length));
  return turn <= 1.0 && firstOrderBending(cable, forces.horizontal, forces.vertical, length).position.norm() <= length;
}

Status noFirstOrder() {
  return {Code::kNotConverged,
          "bending is too large here for its first-order effect to describe it: use a bending model"};
}

}  // namespace

EndPoint correctedCatenaryEnd(const CableProperties& cable, double h, double v, double length) {
  EndPoint end = catenaryEnd(cable, h, v, length);
  if (cable.bending_stiffness == 0.0) return end;
  const EndPoint effect = firstOrderBending(cable, h, v, length);
  end.position += effect.position;
  end.jacobian += effect.jacobian;
  return end;
}

Status checkFirstOrder(const CableProperties& cable, double length, const ForcesAtA& forces) {
  return isFirstOrder(cable, length, forces) ? Status{Code::kConverged, ""} : noFirstOrder();
}

SolveOutcome CorrectedCatenaryCable::startUnder(double length, const ForcesAtA& forces, const SolveLimits& /*limits*/) {
  const Status refusal = catenaryRefusal(properties(), forces);
  if (!refusal.ok()) return {refusal};
  start(length, forces);
  linearise(false);
  return isFirstOrder(properties(), length, forces) ? evaluated() : SolveOutcome{noFirstOrder()};
}

SolveOutcome CorrectedCatenaryCable::startBetween(double length, double x, double y, const SolveLimits& /*limits*/) {
  ForcesAtA forces;
  SolveOutcome outcome = solveCatenaryForces(properties(), length, x, y, &forces);
  start(length, forces);
  if (outcome.status.code == Code::kNotConverged) outcome.status = noFirstOrder();
  if (!outcome.ok()) return outcome;
  double last_size = 1.0;
  bool settled = false;
  for (int i = 0; i < kMaxIterations && !settled; ++i) {
    ++outcome.iterations;
    linearise(false);
    const Eigen::Vector2d defect = Eigen::Vector2d(x, y) - end().position;
    const Eigen::Vector2d change = end().jacobian.leftCols<2>().inverse() * defect;
    const double size = change.norm() / this->forces().tension();
    outcome.closure_residual = defect.norm();
    if (!(size < 1.0) || this->forces().horizontal + change.x() < 0.0) break;
    step({change.x(), change.y(), 0.0}, 1.0);
    settled = size <= kRoundingStep || (size < kSmallStep && size >= 0.5 * last_size);
    last_size = size;
  }
  linearise(false);
  if (!settled || !isFirstOrder(properties(), length, this->forces())) outcome.status = noFirstOrder();
  return outcome;
}

bool CorrectedCatenaryCable::linearise(bool /*adapt*/) {
  return setEnd(correctedCatenaryEnd(properties(), forces().horizontal, forces().vertical, length()));
}

bool CorrectedCatenaryCable::isStraight() const { return properties().weight == 0.0 || !(forces().horizontal > 0.0); }

// Bending follows the catenary's curvature but for the layers at the free ends, where the moment falls to zero.
ProfilePoint CorrectedCatenaryCable::pointAt(double s) const {
  const CableProperties& cable = properties();
  if (isStraight()) return catenaryPoint(cable, forces(), s);
  const double h = forces().horizontal;
  const double u = cable.weight * s - forces().vertical;
  const double tension = std::hypot(h, u);
  const double curvature = cable.weight * h / (tension * tension) / (1.0 + tension / cable.axial_stiffness);
  const double thickness = std::sqrt(cable.bending_stiffness / tension);
  const double layer_a = std::exp(-s / thickness);
  const double layer_b = std::exp(-(length() - s) / thickness);
  const double moment = cable.bending_stiffness * curvature;
  const double inside = (1.0 - layer_a) * (1.0 - layer_b);
  ProfilePoint point;
  point.s = s;
  point.alpha = std::atan2(u, h) + curvature * thickness * (layer_a - layer_b);
  point.moment = moment * inside;
  point.tension = tension;
  point.shear = moment / thickness * (layer_b - layer_a);
  if (s > 0.0) {
    const Eigen::Vector2d middle = correctedCatenaryEnd(cable, h, forces().vertical, s).position +
                                   inside * moment / tension * Eigen::Vector2d(-u, h) / tension;
    point.x = middle.x();
    point.y = middle.y();
  }
  return point;
}

CableSolution CorrectedCatenaryCable::describe(double x, double y, int profile_points) const {
  const CableProperties& cable = properties();
  const double h = forces().horizontal;
  const double v = forces().vertical;
  CableSolution solution = catenaryMeasures(*this, correctedCatenaryEnd(cable, h, v, length()));
  solution.closure_residual = std::hypot(solution.x - x, solution.y - y);
  for (int i = 0; i < profile_points; ++i) solution.profile.push_back(pointAt(length() * i / (profile_points - 1)));
  if (isStraight()) return solution;
  const ProfilePoint a = pointAt(0.0);
  const ProfilePoint b = pointAt(length());
  const double lowest = std::clamp(v / cable.weight, 0.0, length());
  const double lowest_tension = std::hypot(h, cable.weight * lowest - v);
  solution.angle_a = a.alpha;
  solution.angle_b = b.alpha;
  solution.max_moment = cable.bending_stiffness * cable.weight * h / (lowest_tension * lowest_tension) /
                        (1.0 + lowest_tension / cable.axial_stiffness);
  solution.max_shear = std::max(std::abs(a.shear), std::abs(b.shear));
  for (const ProfilePoint& point : solution.profile) {  // thick layers may be sheared most within
    solution.max_shear = std::max(solution.max_shear, std::abs(point.shear));
    solution.max_moment = std::max(solution.max_moment, std::abs(point.moment));
  }
  return solution;
}

}  // namespace cdpr_kinetostatics

#include "cable/straight_cable.h"

#include <algorithm>
#include <cmath>

#include "cable/cable_checks.h"
#include "cable/cable_description.h"
#include "cable/catenary.h"

namespace cdpr_kinetostatics {
namespace {

// The longest line that the search for its length looks at is shorter than its chord by this share, a few roundings.
constexpr double kBarelyStretched = 1e-15;

}  // namespace

Status inextensibleRefusal(double length, double chord, double tolerance) {
  if (std::abs(length - chord) > tolerance * chord) {
    return {Code::kInfeasible, named("an inextensible straight cable of length", length, "m") + " cannot span " +
                                   named("a chord of", chord, "m") + ": use straight_elastic or a catenary"};
  }
  return {Code::kInvalidInput,
          "the tension of an inextensible straight cable does not follow from its geometry: give the tension "
          "(FIND_LENGTH) or use straight_elastic"};
}

EndPoint straightEnd(const CableProperties& cable, double h, double v_a, double length) {
  CableProperties weightless = cable;
  weightless.weight = 0.0;
  EndPoint end = catenaryEnd(weightless, h, v_a - 0.5 * cable.weight * length, length);
  end.jacobian.col(2) -= 0.5 * cable.weight * end.jacobian.col(1);
  return end;
}

ForcesAtA straightForces(const CableProperties& cable, double length, double x, double y) {
  const double chord = std::hypot(x, y);
  const double half_weight = 0.5 * cable.weight * length;
  if (chord <= length) return {0.0, half_weight};
  const double tension = cable.axial_stiffness * (chord - length) / length;
  return {tension * x / chord, half_weight - tension * y / chord};
}

SolveOutcome StraightCable::startUnder(double length, const ForcesAtA& forces, const SolveLimits& /*limits*/) {
  if (pushes(forces)) return {carriesNoCompression(forces.horizontal)};
  if (std::hypot(forces.horizontal, forces.vertical - 0.5 * properties().weight * length) == 0.0) {
    return {{Code::kInvalidInput,
             "a straight cable without tension has no direction: its forces leave nothing but its own weight; give "
             "more force or use a catenary"}};
  }
  start(length, forces);
  linearise(false);
  return evaluated();
}

SolveOutcome StraightCable::startBetween(double length, double x, double y, const SolveLimits& limits) {
  if (std::isinf(properties().axial_stiffness)) {
    return {inextensibleRefusal(length, std::hypot(x, y), limits.tolerance)};
  }
  start(length, straightForces(properties(), length, x, y));
  linearise(false);
  return evaluated();
}

SolveOutcome StraightCable::startWithTension(double x, double y, double tension_a, double* least_tension) {
  const double chord = std::hypot(x, y);
  const double half_weight = 0.5 * properties().weight * chord;
  const double middle = half_weight * y / chord;
  const double square = middle * middle + tension_a * tension_a - half_weight * half_weight;
  *least_tension = middle > 0.0 ? half_weight * x / chord : half_weight;
  if (square < 0.0 || middle + std::sqrt(square) < 0.0) return {belowLeastTension(tension_a, *least_tension)};
  const double tension = middle + std::sqrt(square);
  start(chord, {tension * x / chord, half_weight - tension * y / chord});
  linearise(false);
  return evaluated();
}

bool StraightCable::lengthIsChord(double /*x*/, double /*y*/, double /*tension_a*/, double /*length_hint*/) const {
  return std::isinf(properties().axial_stiffness);
}

double StraightCable::longestLength(double chord, double /*tension_a*/) const {
  return chord * (1.0 - kBarelyStretched);
}

bool StraightCable::linearise(bool /*adapt*/) {
  return setEnd(straightEnd(properties(), forces().horizontal, forces().vertical, length()));
}

CableSolution StraightCable::describe(double x, double y, int profile_points) const {
  const CableProperties& cable = properties();
  CableSolution solution = solutionUnder(cable, length(), forces());
  const double half_weight = 0.5 * cable.weight * length();
  const double tension = std::hypot(forces().horizontal, forces().vertical - half_weight);
  const double angle = std::atan2(y, x);
  solution.x = x;
  solution.y = y;
  solution.angle_a = solution.angle_b = angle;
  if (tension > 0.0) {
    solution.strained_length = length() * (1.0 + tension / cable.axial_stiffness);
    const EndPoint end = straightEnd(cable, forces().horizontal, forces().vertical, length());
    solution.end_jacobian = end.jacobian;
    solution.closure_residual = (end.position - Eigen::Vector2d(x, y)).norm();
    if (std::isfinite(cable.axial_stiffness)) solution.force_jacobian = forceJacobian(end);
  } else {
    solution.force_jacobian(1, 2) = 0.5 * cable.weight;
  }
  zeroNonFinite(&solution.end_jacobian);
  for (int i = 0; i < profile_points; ++i) {
    const double share = static_cast<double>(i) / (profile_points - 1);
    solution.profile.push_back({share * length(), share * x, share * y, angle, 0.0, tension, 0.0});
  }
  return solution;
}

}  // namespace cdpr_kinetostatics

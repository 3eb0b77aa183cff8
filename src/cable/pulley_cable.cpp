#include "cable/pulley_cable.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cable/cable_checks.h"
#include "cable/cable_description.h"
#include "cable/catenary.h"
#include "cable/catenary_cable.h"
#include "cable/corrected_catenary_cable.h"
#include "cable/pulley_description.h"
#include "cable/rope_on_pulley.h"
#include "cable/straight_cable.h"

namespace cdpr_kinetostatics {
namespace {

// The start is sought in turns, the hinged cable's forces and the direction in which they leave the pulley: until the
// direction stands still to this angle [rad], or so many times.
constexpr double kSettledDirection = 1e-3;
constexpr int kMostTurns = 30;

// Newton's method from there takes a few iterations; next to the vertical H falls by a factor in each.
constexpr int kMostIterations = 100;

// A step of the forces [share of the tension] below the first is rounding; one below the second that no longer shrinks
// is, too. Below the third the end's defect is rounding and tells nothing of a step.
constexpr double kRoundingStep = 1e-15;
constexpr double kSmallStep = 1e-7;
constexpr double kNoSearch = 1e-9;

// The horizontal force keeps this share of itself in a step, which is never shortened below the last.
constexpr double kLeastShare = 0.1;
constexpr double kShortestStep = 1e-6;

// The free length of a line changes by a share q (dead length)/EA of itself in each step, to rounding in these.
constexpr int kLineSteps = 8;

// The axial stiffness of the free part in series with what stretches before it.
CableProperties inSeries(const CableProperties& cable, double free_length) {
  CableProperties free = freePartOf(cable);
  const double before = cable.dead_length + M_PI_2 * cable.pulley.radius;
  free.axial_stiffness *= free_length / (free_length + before);
  return free;
}

// B from the point where a straight rope leaves the pulley; x is not negative but by rounding.
Eigen::Vector2d fromTangentPoint(const GuidePulley& pulley, double x, double y) {
  const double angle = tangentLine(pulley, x, y)->angle;
  const Eigen::Vector2d way = Eigen::Vector2d(x, y) - departurePoint(pulley, angle);
  return {std::max(way.x(), 0.0), way.y()};
}

}  // namespace

std::optional<ForcesAtA> hangingForces(const CableProperties& cable, double length, double x, double y) {
  if (beginsAtEyelet(cable)) return catenaryForces(cable, length, x, y);
  if (cable.bending_stiffness > 0.0) {
    PulleyCable corrected(cable, FreeShape::kCorrected);
    if (corrected.startBetween(length, x, y, {}).ok()) return corrected.forces();
  }
  PulleyCable catenary(cable, FreeShape::kCatenary);
  return catenary.startBetween(length, x, y, {}).ok() ? std::optional(catenary.forces()) : std::nullopt;
}

Status pulleyRefusal(const CableProperties& cable, double length, double x, double y) {
  PulleyCable corrected(cable, FreeShape::kCorrected);
  const SolveOutcome outcome = corrected.startBetween(length, x, y, {});
  return outcome.status.code == Code::kInfeasible ? outcome.status : Status{Code::kConverged, ""};
}

// The weight that is lumped where the rope leaves says nothing of what the pulley holds.
Status PulleyCable::contact() const {
  if (shape_ == FreeShape::kStraight) return checkWrap(properties().pulley, at_.angle);
  if (shape_ == FreeShape::kCorrected) {
    const Status first_order = checkFirstOrder(properties(), at_.free_length, forces());
    if (!first_order.ok()) return first_order;
  }
  return checkContact(properties(), forces(), at_.angle);
}

SolveOutcome PulleyCable::startUnder(double length, const ForcesAtA& forces, const SolveLimits& /*limits*/) {
  const Status refusal = catenaryRefusal(properties(), forces);
  if (!refusal.ok()) return {refusal};
  start(length, forces);
  if (linearise(false)) return {contact()};
  if (at_.free_length > 0.0) return {{Code::kInvalidInput, "the cable has no end or no direction under these forces"}};
  return {{Code::kInfeasible, named("a cable of length", length, "m") + " does not reach around its guide pulley"}};
}

// A line between given ends has the direction of the tangent, whatever its tension; half of its weight at A stretches
// what lies before it.
void PulleyCable::startLine(double length, double angle, double tension) {
  at_.angle = angle;
  at_.free_length = length;
  for (int i = 0; i <= kLineSteps; ++i) {
    start(length, {tension * std::cos(angle), 0.5 * properties().weight * at_.free_length - tension * std::sin(angle)});
    if (i < kLineSteps) at_.free_length = length - heldRope(properties(), forces(), angle).length;
  }
}

// The tension is what stretches the line to its chord, by the rule of false position (Illinois). A line that is long
// enough without any is slack.
SolveOutcome PulleyCable::stretchLine(double length, double x, double y) {
  const double angle = tangentLine(properties().pulley, x, y)->angle;
  const double chord = fromTangentPoint(properties().pulley, x, y).norm();
  const auto excess = [&](double tension) {
    startLine(length, angle, tension);
    return at_.free_length * (1.0 + tension / properties().axial_stiffness) - chord;
  };
  at_ = {};
  at_.free_length_by = Eigen::RowVector3d::UnitZ();
  double low = 0.0;
  double below = excess(low);
  if (below >= 0.0) return evaluated();
  double high = -below / chord * properties().axial_stiffness;
  double above = excess(high);
  for (int i = 0; i < kMostIterations && !(above >= 0.0); ++i) above = excess(high *= 2.0);
  for (int i = 0; i < kMostIterations && std::abs(above) > kRoundingStep * chord; ++i) {
    const double tension = high - above * (high - low) / (above - below);
    const double here = excess(tension);
    if ((here < 0.0) == (above < 0.0)) {
      below *= 0.5;
    } else {
      low = high;
      below = above;
    }
    if (std::abs(tension - high) <= kRoundingStep * high) break;
    high = tension;
    above = here;
  }
  linearise(false);
  return evaluated();
}

ForcesAtA PulleyCable::roughForces(double length, double x, double y) const {
  const GuidePulley& pulley = properties().pulley;
  double angle = tangentLine(pulley, x, y)->angle;
  ForcesAtA forces;
  for (int i = 0; i < kMostTurns; ++i) {
    const Eigen::Vector2d way = Eigen::Vector2d(x, y) - departurePoint(pulley, angle);
    const double free_length = length - pulley.radius * wrapAngle(pulley, angle);
    if (!(free_length > 0.0)) break;
    const std::optional<ForcesAtA> next =
        catenaryForces(inSeries(properties(), free_length), free_length, std::max(way.x(), 0.0), way.y());
    if (!next) break;
    forces = *next;
    const double last = angle;
    angle = std::atan2(-forces.vertical, forces.horizontal);
    if (std::abs(angle - last) < kSettledDirection) break;
  }
  return forces;
}

SolveOutcome PulleyCable::closeEnd(double x, double y) {
  SolveOutcome outcome{
      {Code::kNotConverged,
       "the forces of the cable on its guide pulley were not found: another model may find them, BENDING for "
       "a rope that is stiff for its pulley"}};
  if (!linearise(false)) return outcome;
  double last_step = std::numeric_limits<double>::infinity();
  while (outcome.iterations < kMostIterations) {
    ++outcome.iterations;
    const Eigen::Vector2d defect = Eigen::Vector2d(x, y) - end().position;
    outcome.closure_residual = defect.norm();
    const Eigen::Vector2d step = end().jacobian.leftCols<2>().inverse() * defect;
    if (!step.allFinite()) return outcome;
    const ForcesAtA from = forces();
    const double tension = from.tension() + properties().weight * length();
    const double least = (kLeastShare - 1.0) * from.horizontal;
    double share = step.x() < least ? least / step.x() : 1.0;
    for (;; share *= 0.5) {
      start(length(), {from.horizontal + share * step.x(), from.vertical + share * step.y()});
      const bool evaluated = linearise(false);
      const bool nearer = evaluated && (Eigen::Vector2d(x, y) - end().position).norm() < defect.norm();
      if (nearer || (evaluated && step.norm() < kNoSearch * tension)) break;
      if (share < kShortestStep) return outcome;
    }
    if (step.norm() <= kRoundingStep * tension ||
        (step.norm() < kSmallStep * tension && step.norm() >= 0.5 * last_step)) {
      outcome.status = {Code::kConverged, ""};
      return outcome;
    }
    last_step = step.norm();
  }
  return outcome;
}

SolveOutcome PulleyCable::startBetween(double length, double x, double y, const SolveLimits& limits) {
  const Status reach = checkReach(properties().pulley, x, y);
  if (!reach.ok()) return {reach};
  const double way = tangentLine(properties().pulley, x, y)->length;
  if (shape_ == FreeShape::kStraight) {
    if (std::isinf(properties().axial_stiffness)) return {inextensibleRefusal(length, way, limits.tolerance)};
    return stretchLine(length, x, y);
  }
  const Status reaches = catenaryReach(properties(), length, way);
  if (!reaches.ok()) return {reaches};
  start(length, roughForces(length, x, y));
  const SolveOutcome outcome = closeEnd(x, y);
  if (!outcome.ok()) return outcome;
  return {contact(), outcome.iterations, outcome.closure_residual};
}

SolveOutcome PulleyCable::startWithTension(double x, double y, double tension_a, double* least_tension) {
  const Status reach = checkReach(properties().pulley, x, y);
  if (!reach.ok()) return {reach};
  StraightCable line(freePartOf(properties()));
  const Eigen::Vector2d way = fromTangentPoint(properties().pulley, x, y);
  const SolveOutcome outcome = line.startWithTension(way.x(), way.y(), tension_a, least_tension);
  if (!outcome.ok()) return outcome;
  start(tangentLine(properties().pulley, x, y)->length, line.forces());
  linearise(false);
  return outcome;
}

bool PulleyCable::lengthIsChord(double x, double y, double tension_a, double length_hint) const {
  if (!std::isinf(properties().axial_stiffness) || !checkReach(properties().pulley, x, y).ok()) return false;
  if (shape_ == FreeShape::kStraight) return true;
  const Eigen::Vector2d way = fromTangentPoint(properties().pulley, x, y);
  const double wrapped = tangentLine(properties().pulley, x, y)->length - way.norm();
  return isString(properties(), way.x(), way.y(), tension_a, length_hint - wrapped);
}

double PulleyCable::longestLength(double way, double tension_a) const {
  if (shape_ == FreeShape::kStraight) return StraightCable(properties()).longestLength(way, tension_a);
  return longestSagging(properties().weight, way, tension_a) + M_PI * properties().pulley.radius;
}

bool PulleyCable::linearise(bool /*adapt*/) {
  at_ = pulleyEnd(properties(), shape_, forces(), length());
  return setEnd(at_.end);
}

void PulleyCable::step(const Eigen::Vector3d& change, double damping) {
  at_.free_length += damping * at_.free_length_by.dot(change);
  ClosedFormCable::step(change, damping);
}

CableSolution PulleyCable::describe(double x, double y, int profile_points) const {
  const Eigen::Vector2d way = Eigen::Vector2d(x, y) - departurePoint(properties().pulley, at_.angle);
  const CableProperties free_properties = freePartOf(properties());
  const auto described = [&](auto free) {
    free.start(at_.free_length, forces());
    return free.describe(way.x(), way.y(), profile_points);
  };
  CableSolution solution = shape_ == FreeShape::kStraight    ? described(StraightCable(free_properties))
                           : shape_ == FreeShape::kCorrected ? described(CorrectedCatenaryCable(free_properties))
                                                             : described(CatenaryCable(free_properties));
  if (shape_ == FreeShape::kCorrected) addPulleyLayer(properties(), at_, &solution);
  addHeldRope(properties(), length(), &solution);
  if (shape_ == FreeShape::kCorrected) solution.closure_residual = std::hypot(solution.x - x, solution.y - y);
  if (solution.end_jacobian.isZero()) return solution;  // a slack line has no derivatives
  solution.end_jacobian = at_.end.jacobian;
  if (!solution.force_jacobian.isZero()) solution.force_jacobian = forceJacobian(at_.end);
  zeroNonFinite(&solution.end_jacobian);
  return solution;
}

}  // namespace cdpr_kinetostatics

#include "cable/rope_on_pulley.h"

#include <algorithm>
#include <cmath>

#include "cable/text.h"

namespace cdpr_kinetostatics {
namespace {

// Angles, and forces as shares of the tension, are zero but for this: the rounding of a converged solution.
constexpr double kRounding = 1e-9;

// Share of what lifts a rope off, EI/r = 2 T r, from which on it is said to be the reason why nothing was found.
constexpr double kNearlyTooStiff = 0.7;

// Of half the angle by which a bending layer turns: the rope lifts off beyond sqrt(1/2).
constexpr double kLargestSine = 0.75;

Status infeasible(const std::string& sentence) { return {Code::kInfeasible, sentence}; }

}  // namespace

CableProperties freePartOf(const CableProperties& cable) {
  CableProperties free = cable;
  free.pulley = {};
  free.dead_length = 0.0;
  return free;
}

double wrapAngle(const GuidePulley& pulley, double alpha) { return M_PI_2 - senseOf(pulley) * alpha; }

Eigen::Vector2d departurePoint(const GuidePulley& pulley, double alpha) {
  const double r = pulley.radius;
  const double sense = senseOf(pulley);
  return {r * (1.0 - sense * std::sin(alpha)), sense * r * std::cos(alpha)};
}

Eigen::Vector2d departureDerivative(const GuidePulley& pulley, double alpha) {
  return -senseOf(pulley) * pulley.radius * Eigen::Vector2d(std::cos(alpha), std::sin(alpha));
}

double momentAtDeparture(const CableProperties& cable) {
  return hasPulley(cable) ? -senseOf(cable.pulley) * cable.bending_stiffness / cable.pulley.radius : 0.0;
}

double tautDeparture(const CableProperties& cable, const ForcesAtA& forces) {
  const double angle = std::atan2(-forces.vertical, forces.horizontal);
  if (!hasPulley(cable) || cable.bending_stiffness == 0.0) return angle;
  const double thickness = std::sqrt(cable.bending_stiffness / forces.tension());
  const double half_turn = std::asin(std::min(0.5 * thickness / cable.pulley.radius, kLargestSine));
  return angle + 2.0 * senseOf(cable.pulley) * half_turn;
}

HeldRope heldRope(const CableProperties& cable, const ForcesAtA& forces, double alpha) {
  const double compliance = 1.0 / cable.axial_stiffness;
  const double c = std::cos(alpha);
  const double s = std::sin(alpha);
  HeldRope held;
  if (hasPulley(cable)) {
    const double way = cable.pulley.radius * wrapAngle(cable.pulley, alpha);
    const double stretch = 1.0 + compliance * (forces.horizontal * c - forces.vertical * s);
    const double by_tension = -way * compliance / (stretch * stretch);
    held.length = way / stretch;
    held.by_forces = by_tension * Eigen::Vector2d(c, -s);
    held.by_angle = -senseOf(cable.pulley) * cable.pulley.radius / stretch -
                    by_tension * (forces.horizontal * s + forces.vertical * c);
  }
  const double tension = forces.tension();
  if (cable.dead_length > 0.0 && tension > 0.0) {
    const double stretch = 1.0 + compliance * tension;
    held.length -= cable.dead_length * compliance * tension / stretch;
    held.by_forces -= cable.dead_length * compliance / (stretch * stretch * tension) *
                      Eigen::Vector2d(forces.horizontal, forces.vertical);
  }
  return held;
}

std::optional<TangentLine> tangentLine(const GuidePulley& pulley, double x, double y) {
  const double r = pulley.radius;
  const double distance = std::hypot(x - r, y);
  if (!(r == 0.0 || distance > r)) return std::nullopt;
  if (r == 0.0) return TangentLine{std::atan2(y, x), distance};
  const double angle = std::atan2(y, x - r) - senseOf(pulley) * std::asin(r / distance);
  return TangentLine{angle, r * wrapAngle(pulley, angle) + std::sqrt((distance - r) * (distance + r))};
}

Status checkWrap(const GuidePulley& pulley, double alpha) {
  if (pulley.radius == 0.0) return {Code::kConverged, ""};
  const double wrap = wrapAngle(pulley, alpha);
  if (wrap > M_PI + kRounding) {
    return infeasible(text("the rope would go around its guide pulley by ", wrap,
                           " rad, more than half a turn: the end of the cable must not lie below or above the pulley "
                           "itself; move it away from the pulley's axis"));
  }
  if (wrap <= -kRounding) {
    return infeasible(
        "the rope would leave its guide pulley before it touches it: it is too stiff for its tension, rope_from says "
        "the "
        "other side, or the end of the cable lies behind the pulley");
  }
  return {Code::kConverged, ""};
}

double straightWay(const CableProperties& cable, double x, double y) {
  return hasPulley(cable) ? tangentLine(cable.pulley, x, y)->length : std::hypot(x, y);
}

Status checkReach(const GuidePulley& pulley, double x, double y) {
  if (pulley.radius == 0.0) return {Code::kConverged, ""};
  const std::optional<TangentLine> line = tangentLine(pulley, x, y);
  if (!line) {
    return infeasible(text("the end of the cable lies within its guide pulley, ", std::hypot(x - pulley.radius, y),
                           " m from its axis: move it out of the radius of ", pulley.radius, " m"));
  }
  return checkWrap(pulley, line->angle);
}

Status liftsOff(const GuidePulley& pulley) {
  return infeasible(text("the rope would lift off its guide pulley of radius ", pulley.radius,
                         " m: it is too slack or too stiff to lie on it; give it more tension, or describe an eyelet "
                         "(radius 0)"));
}

Status checkContact(const CableProperties& cable, const ForcesAtA& forces, double alpha) {
  if (!hasPulley(cable)) return {Code::kConverged, ""};
  const double c = std::cos(alpha);
  const double s = std::sin(alpha);
  const double tension = forces.tension();
  const double sense = senseOf(cable.pulley);
  const double along = forces.horizontal * c - forces.vertical * s;
  const double across = sense * (forces.horizontal * s + forces.vertical * c);
  const bool bends = cable.bending_stiffness > 0.0;
  const bool bends_more = !bends && sense < 0.0 && cable.weight * cable.pulley.radius * c > tension;
  if (along < -kRounding * tension || (bends && across < -kRounding * tension) || bends_more) {
    return liftsOff(cable.pulley);
  }
  return checkWrap(cable.pulley, alpha);
}

bool isTooStiff(const CableProperties& cable, const ForcesAtA& forces) {
  const double moment = momentAtDeparture(cable);
  return hasPulley(cable) && std::abs(moment) > 2.0 * kNearlyTooStiff * forces.tension() * cable.pulley.radius;
}

Status mayLiftOff(const GuidePulley& pulley) {
  return {Code::kNotConverged,
          text("no shape was found in which the rope lies on its guide pulley of radius ", pulley.radius,
               " m: it is so slack or so stiff that it is near to where it would lift off, or "
               "beyond; give it more tension, or describe an eyelet (radius 0)")};
}

}  // namespace cdpr_kinetostatics

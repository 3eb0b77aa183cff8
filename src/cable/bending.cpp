#include "cable/bending.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cable/bending_newton.h"
#include "cable/bending_path.h"
#include "cable/cable_checks.h"
#include "cable/pulley_cable.h"
#include "cable/rope_on_pulley.h"
#include "cable/tautness.h"

namespace cdpr_kinetostatics {
namespace {

// The signed area below the chord may be negative by this share of the square of the length: rounding of a straight
// cable's.
constexpr double kAreaRounding = 1e-10;

// A cable is unloaded below the first share of its buckling load; the second is far above the rounding of its chain and
// far below what stretches it.
constexpr double kUnloaded = 1e-12;
constexpr double kRoundingPull = 1e-9;

// A weightless loop whose ends coincide, but for this share of its length, may be turned about them without any force.
// It hangs down as the lightest loop does: one with this share of a weight that would bend it.
constexpr double kCoinciding = 1e-8;
constexpr double kFeather = 1e-6;

// A shape that turns by more than this has a loop in it. The largest turn without one is the teardrop of a
// weightless elastica whose ends touch, 261 degrees. [rad]
constexpr double kLoopAngle = 1.65 * M_PI;

// The catenary is a safe start where it spans this many bending layers and bends gently (kSafeBend).
constexpr double kSafeLayers = 40.0;

// A light cable gets some weight, so that it knows which side is down: as much as bends it by 1/24 rad, or stretches
// it by this share.
constexpr double kStretchByWeight = 1e-4;

// Slack cables are opened at most to this share of the width that a straight line of the same length and height has.
// The widths that are tried go down from there by a factor, to 1e-5 of it.
constexpr double kWide = 0.6;
constexpr double kOpening = 1.3;
constexpr int kOpenings = 44;

// A start that is not safe enough is made softer by this factor, so many times: to 1e-9 of its EI.
constexpr double kSofter = 0.03;
constexpr int kMostSofter = 6;

// Steps of the continuation: the hardest of the stability map's cables (docs/stability.md) take some hundred.
constexpr int kMaxPathSteps = 400;

// On a pulley there is tension, and a path that is not short leads to where the rope lifts off.
constexpr int kMaxPulleySteps = 40;

// A point of the path along which a safe problem becomes the one asked for.
struct PathPoint {
  CableProperties cable;
  double x = 0.0;
};

PathPoint between(const PathPoint& a, const PathPoint& b, double share) {
  PathPoint p = b;
  p.cable.bending_stiffness =
      a.cable.bending_stiffness * std::pow(b.cable.bending_stiffness / a.cable.bending_stiffness, share);
  p.cable.weight = a.cable.weight + share * (b.cable.weight - a.cable.weight);
  p.x = a.x + share * (b.x - a.x);
  return p;
}

// A problem whose answer is close to its catenary, at the same length and height difference.
struct SafeStart {
  PathPoint point;
  ForcesAtA forces;  // of its catenary
};

// The catenary at the largest width, at most the safe one, at which it bends gently.
std::optional<ForcesAtA> openCatenary(double length, double x, double y, const SolveLimits& limits, PathPoint* start) {
  const double longest = length * (1.0 + start->cable.weight * length / start->cable.axial_stiffness);
  const double wide = longest > std::abs(y) ? kWide * std::sqrt((longest - y) * (longest + y)) : 0.0;
  std::optional<ForcesAtA> catenary;
  for (int i = kOpenings; i >= 0 && !limits.haveEnded(); --i) {
    start->x = std::max(x, wide * std::pow(kOpening, -i));
    catenary = hangingForces(start->cable, length, start->x, y);
    if (start->x >= wide || (catenary && sharpestBend(start->cable, length, *catenary) < kSafeBend)) break;
  }
  return catenary;
}

std::optional<SafeStart> safeStart(const CableProperties& cable, double length, double x, double y,
                                   const SolveLimits& limits) {
  PathPoint start{cable, x};
  const double light =
      std::min(cable.bending_stiffness / (length * length * length), kStretchByWeight * cable.axial_stiffness / length);
  start.cable.weight = std::max(cable.weight, light);
  const std::optional<ForcesAtA> catenary = openCatenary(length, x, y, limits, &start);
  if (!catenary || !pullsAllAlong(start.cable, length, *catenary)) return std::nullopt;
  const double tension = std::hypot(catenary->horizontal, catenary->vertical);
  const double by_layers = tension * std::pow(length / kSafeLayers, 2);
  const double bend = sharpestBend(start.cable, length, *catenary);
  const double by_bend = bend > 0.0 ? cable.bending_stiffness * kSafeBend / bend : by_layers;
  start.cable.bending_stiffness = std::min({cable.bending_stiffness, by_layers, by_bend});
  return SafeStart{start, *catenary};
}

// WRONG_BRANCH if shooting has converged to another equilibrium than the one asked for, INFEASIBLE if to one that its
// pulley does not hold.
SolveOutcome checked(SolveOutcome outcome, const MultipleShooting& shooting) {
  if (outcome.status.ok()) outcome.status = shooting.contact();
  if (outcome.status.ok() && !onSaggingBranch(shooting)) {
    outcome.status = {Code::kWrongBranch, "the cable snapped to another equilibrium"};
  }
  return outcome;
}

// No other start needs to be tried.
bool isFinal(const SolveOutcome& outcome) {
  return outcome.status.ok() || outcome.status.code == Code::kTimedOut || outcome.status.code == Code::kInfeasible;
}

SolveOutcome continueFromCatenary(const CableProperties& cable, double length, double x, double y,
                                  const SolveLimits& limits, MultipleShooting* shooting) {
  std::optional<SafeStart> safe = safeStart(cable, length, x, y, limits);
  if (limits.haveEnded()) {
    return {{Code::kTimedOut, "the time allowed ran out while looking for a catenary to start from"}};
  }
  if (!safe) return {{Code::kNotConverged, "no catenary to start from"}};
  SolveOutcome outcome;
  PathPoint& start = safe->point;
  for (int i = 0; i < kMostSofter; ++i, start.cable.bending_stiffness *= kSofter) {
    shooting->start(start.cable, length, safe->forces.horizontal, safe->forces.vertical, limits.tolerance);
    outcome.then(newton({Goal::kEndPoint, length, {start.x, y}}, limits, kMaxNewtonIterations, shooting));
    if (isFinal(checked(outcome, *shooting))) break;
  }
  if (!outcome.status.ok()) return outcome;

  const PathPoint goal{cable, x};
  const bool changes = start.cable.bending_stiffness != cable.bending_stiffness || start.cable.weight != cable.weight;
  return followPath(
      outcome, hasPulley(cable) ? kMaxPulleySteps : kMaxPathSteps,
      "the sagging equilibrium was lost on the way from the catenary to this bending stiffness",
      [&](double share) {
        const PathPoint point = between(start, goal, share);
        if (changes) shooting->changeProperties(point.cable);
        return followBendingForces(length, point.x, y, limits, shooting);
      },
      shooting);
}

// A weightless cable as long as the distance of its ends lies between them without any force. It has no stiffness
// across itself, so that Newton's method has nothing to go by; it is evaluated under a pull of rounding size.
SolveOutcome lieUnloaded(const CableProperties& cable, double length, double x, double y, const SolveLimits& limits,
                         MultipleShooting* shooting) {
  const double angle = std::atan2(y, x);
  const double pull = kRoundingPull * bucklingForce(cable, length);
  shooting->startAlong(cable, length, {pull * std::cos(angle), -pull * std::sin(angle)}, angle, limits.tolerance);
  if (shooting->linearise(true, limits.deadline)) return {{Code::kConverged, ""}};
  return {{Code::kNotConverged, "the unloaded cable could not be evaluated"}};
}

}  // namespace

bool onSaggingBranch(const MultipleShooting& shooting) {
  const double length = shooting.length();
  return shooting.stable() &&
         shooting.areaBelowChord() >= -kAreaRounding * length * length - shooting.areaOfPulleyMoment() &&
         std::abs(shooting.turning()) < kLoopAngle;
}

SolveOutcome solveBendingForces(const CableProperties& cable, double length, double x, double y,
                                const SolveLimits& limits, MultipleShooting* shooting) {
  const Status reach = hasPulley(cable) ? pulleyRefusal(cable, length, x, y) : Status{Code::kConverged, ""};
  if (!reach.ok()) return {reach};
  const double way = straightWay(cable, x, y);
  if (std::isinf(cable.axial_stiffness) && way >= length) return {cannotReach(length, way)};
  const double feather = kFeather * cable.bending_stiffness / (length * length * length);
  if (cable.weight < feather && std::hypot(x, y) <= kCoinciding * length) {
    CableProperties light = cable;
    light.weight = feather;
    return solveBendingForces(light, length, x, y, limits, shooting);
  }
  SolveOutcome outcome;
  const std::optional<ForcesAtA> catenary = hangingForces(cable, length, x, y);
  if (catenary && pullsAllAlong(cable, length, *catenary) && sharpestBend(cable, length, *catenary) < kSharpBend) {
    shooting->start(cable, length, catenary->horizontal, catenary->vertical, limits.tolerance);
    outcome.then(newton({Goal::kEndPoint, length, {x, y}}, limits, kMaxNewtonIterations, shooting));
    const SolveOutcome direct = checked(outcome, *shooting);
    if (isFinal(direct)) return direct;
  }
  if (hasPulley(cable)) {  // which holds no rope that pushes
    outcome.then(continueFromCatenary(cable, length, x, y, limits, shooting));
    const bool lost = outcome.status.code == Code::kNotConverged || outcome.status.code == Code::kWrongBranch;
    if (lost && isTooStiff(cable, shooting->forces())) outcome.status = mayLiftOff(cable.pulley);
    return outcome;
  }
  const double compression = std::isfinite(cable.axial_stiffness)
                                 ? cable.axial_stiffness * (1.0 - std::hypot(x, y) / length)
                                 : std::numeric_limits<double>::infinity();
  const bool apart = std::hypot(x, y) > 0.0;  // ends that coincide have no line between them
  if (apart && cable.weight == 0.0 && std::abs(compression) <= kUnloaded * bucklingForce(cable, length)) {
    return lieUnloaded(cable, length, x, y, limits, shooting);
  }
  if (apart && compression >= -cable.weight * length && compression < bucklingForce(cable, length)) {
    shooting->startStraight(cable, length, x, y, limits.tolerance);
    outcome.then(newton({Goal::kEndPoint, length, {x, y}}, limits, kMaxNewtonIterations, shooting));
    if (isFinal(checked(outcome, *shooting))) return outcome;
  }
  outcome.then(continueFromCatenary(cable, length, x, y, limits, shooting));
  return outcome;
}

SolveOutcome followBendingForces(double length, double x, double y, const SolveLimits& limits,
                                 MultipleShooting* shooting) {
  return checked(newton({Goal::kEndPoint, length, {x, y}}, limits, kMaxFollowIterations, shooting), *shooting);
}

}  // namespace cdpr_kinetostatics

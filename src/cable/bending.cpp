#include "cable/bending.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cable/bending_newton.h"
#include "cable/cable_checks.h"
#include "cable/catenary.h"
#include "cable/tautness.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxPathSteps = 400;

// A shape that turns by more than this has a loop in it. The largest turn without one is the teardrop of a
// weightless elastica whose ends touch, 261 degrees.
constexpr double kLoopAngle = 1.65 * M_PI;

// The catenary is a safe start where it spans this many bending layers and bends gently.
constexpr double kSafeLayers = 40.0;
// Width to which slack cables are opened at most, over that of a straight line of the same length and height; opening
// takes at most so many steps by this factor.
constexpr double kWide = 0.6;
constexpr double kOpening = 1.3;
constexpr int kOpenings = 44;
// A start that is not safe enough is made softer by this factor, so many times.
constexpr double kSofter = 0.03;
constexpr int kMostSofter = 6;

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
std::optional<PathPoint> safeStart(const CableProperties& cable, double length, double x, double y, ForcesAtA* forces) {
  PathPoint start{cable, x};
  const double light = std::min(cable.bending_stiffness / std::pow(length, 3), 1e-4 * cable.axial_stiffness / length);
  start.cable.weight = std::max(cable.weight, light);
  // A slack cable is opened, but no wider than it takes to bend gently.
  const double longest = length * (1.0 + start.cable.weight * length / cable.axial_stiffness);
  const double wide = longest > std::abs(y) ? kWide * std::sqrt((longest - y) * (longest + y)) : 0.0;
  std::optional<ForcesAtA> catenary;
  for (int i = kOpenings; i >= 0; --i) {
    start.x = std::max(x, wide * std::pow(kOpening, -i));
    catenary = catenaryForces(start.cable, length, start.x, y);
    if (start.x >= wide || (catenary && sharpestBend(start.cable, length, *catenary) < kSafeBend)) break;
  }
  if (!catenary || !pullsAllAlong(start.cable, length, *catenary)) return std::nullopt;
  *forces = *catenary;
  const double tension = std::hypot(forces->horizontal, forces->vertical);
  const double by_layers = tension * std::pow(length / kSafeLayers, 2);
  const double bend = sharpestBend(start.cable, length, *forces);
  const double by_bend = bend > 0.0 ? cable.bending_stiffness * kSafeBend / bend : by_layers;
  start.cable.bending_stiffness = std::min({cable.bending_stiffness, by_layers, by_bend});
  return start;
}

SolveOutcome continueFromCatenary(const CableProperties& cable, double length, double x, double y,
                                  const SolveLimits& limits, MultipleShooting* shooting) {
  ForcesAtA forces;
  std::optional<PathPoint> start = safeStart(cable, length, x, y, &forces);
  if (!start) return {{Code::kNotConverged, "no catenary to start from"}};
  SolveOutcome outcome;
  const PathPoint goal{cable, x};
  for (int i = 0; i < kMostSofter; ++i, start->cable.bending_stiffness *= kSofter) {
    shooting->start(start->cable, length, forces.horizontal, forces.vertical, limits.tolerance);
    outcome.then(newton({Goal::kEndPoint, length, {start->x, y}}, limits, kMaxNewtonIterations, shooting));
    if (outcome.status.code == Code::kTimedOut || (outcome.status.ok() && onSaggingBranch(*shooting))) break;
  }
  if (!outcome.status.ok()) return outcome;

  MultipleShooting last = *shooting;
  double share = 0.0;
  double step = 0.25;
  for (int i = 0; i < kMaxPathSteps && share < 1.0; ++i) {
    const double next = std::min(1.0, share + step);
    const PathPoint point = between(*start, goal, next);
    if (start->cable.bending_stiffness != cable.bending_stiffness || start->cable.weight != cable.weight) {
      shooting->changeProperties(point.cable);
    }
    const SolveOutcome local = newton({Goal::kEndPoint, length, {point.x, y}}, limits, 12, shooting);
    outcome.count(local);
    if (local.status.code == Code::kTimedOut) {
      outcome.status = local.status;
      return outcome;
    }
    if (local.status.ok() && onSaggingBranch(*shooting)) {
      last = *shooting;
      share = next;
      step *= 1.7;
    } else {
      shooting->restore(last);
      step *= 0.4;
      if (step < 1e-5) break;
    }
  }
  if (share < 1.0) {
    outcome.status = {Code::kNotConverged,
                      "the sagging equilibrium was lost on the way from the catenary to this bending stiffness"};
  }
  return outcome;
}

}  // namespace

bool onSaggingBranch(const MultipleShooting& shooting) {
  const double length = shooting.length();
  return shooting.stable() && shooting.areaBelowChord() >= -1e-10 * length * length &&
         std::abs(shooting.turning()) < kLoopAngle;
}

SolveOutcome solveBendingForces(const CableProperties& cable, double length, double x, double y,
                                const SolveLimits& limits, MultipleShooting* shooting) {
  if (std::isinf(cable.axial_stiffness) && std::hypot(x, y) >= length) return {cannotReach(length, std::hypot(x, y))};
  SolveOutcome outcome;
  const std::optional<ForcesAtA> catenary = catenaryForces(cable, length, x, y);
  if (catenary && pullsAllAlong(cable, length, *catenary) && sharpestBend(cable, length, *catenary) < kSharpBend) {
    shooting->start(cable, length, catenary->horizontal, catenary->vertical, limits.tolerance);
    outcome.then(newton({Goal::kEndPoint, length, {x, y}}, limits, kMaxNewtonIterations, shooting));
    if (outcome.status.code == Code::kTimedOut || (outcome.status.ok() && onSaggingBranch(*shooting))) return outcome;
  }
  const double compression = std::isfinite(cable.axial_stiffness)
                                 ? cable.axial_stiffness * (1.0 - std::hypot(x, y) / length)
                                 : std::numeric_limits<double>::infinity();
  if (compression >= -cable.weight * length && compression < cable.bending_stiffness * std::pow(M_PI / length, 2)) {
    shooting->startStraight(cable, length, x, y, limits.tolerance);
    outcome.then(newton({Goal::kEndPoint, length, {x, y}}, limits, kMaxNewtonIterations, shooting));
    if (outcome.status.code == Code::kTimedOut || (outcome.status.ok() && onSaggingBranch(*shooting))) return outcome;
  }
  outcome.then(continueFromCatenary(cable, length, x, y, limits, shooting));
  return outcome;
}

SolveOutcome followBendingForces(double length, double x, double y, const SolveLimits& limits,
                                 MultipleShooting* shooting) {
  SolveOutcome outcome = newton({Goal::kEndPoint, length, {x, y}}, limits, 12, shooting);
  if (outcome.status.ok() && !onSaggingBranch(*shooting)) {
    outcome.status = {Code::kWrongBranch, "the cable snapped to another equilibrium"};
  }
  return outcome;
}

}  // namespace cdpr_kinetostatics

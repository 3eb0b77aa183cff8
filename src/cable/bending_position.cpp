// Problem 1: from forces to the end point.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "cable/bending_newton.h"
#include "cable/tautness.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxPositionIterations = 60;
constexpr int kMaxLoopSteps = 40;
// While problem 1 moves the end point: its longest and shortest move, as shares of the length, and the share of the
// buckling load from which a compressed cable is taken for a strut rather than for a loop.
constexpr double kLongestMove = 0.1;
constexpr double kShortestMove = 1e-9;
constexpr double kStrutShare = 0.3;

// Problem 1 by a single shot from every angle at A: up to this many bending layers, with so many angles, and so
// many bisections where the moment at B changes sign.
constexpr double kScanLayers = 8.0;
constexpr int kScanAngles = 90;
constexpr int kScanBisections = 12;
constexpr double kScanTolerance = 1e-6;

// Moves the end point from a start until the forces are those asked for.
SolveOutcome moveEndToForces(const CableProperties& cable, double length, const ForcesAtA& forces, Eigen::Vector2d end,
                             const SolveLimits& limits, MultipleShooting* shooting) {
  SolveOutcome outcome = solveBendingForces(cable, length, end.x(), end.y(), limits, shooting);
  const double scale = std::max(std::hypot(forces.horizontal, forces.vertical), cable.weight * length);
  double reach = kLongestMove * length;
  for (int i = 0; i < kMaxPositionIterations && outcome.status.ok(); ++i) {
    const Eigen::Vector2d missing(forces.horizontal - shooting->horizontalForce(),
                                  forces.vertical - shooting->verticalForceA());
    if (missing.norm() <= 1e-3 * scale) {
      outcome.then(followBendingPosition(length, forces, limits, shooting));
      return outcome;
    }
    Eigen::Vector2d step = shooting->end().jacobian.leftCols<2>() * missing;
    step *= std::min(1.0, reach / step.norm());
    if (end.x() + step.x() < 0.0) step *= 0.5 * end.x() / -step.x();
    if (step.norm() < kShortestMove * length) break;
    const MultipleShooting last = *shooting;
    const SolveOutcome local = followBendingForces(length, end.x() + step.x(), end.y() + step.y(), limits, shooting);
    outcome.count(local);
    if (local.status.code == Code::kTimedOut) {
      outcome.status = local.status;
      return outcome;
    }
    const double left =
        std::hypot(forces.horizontal - shooting->horizontalForce(), forces.vertical - shooting->verticalForceA());
    if (local.status.ok() && left <= 2.0 * missing.norm()) {
      end += step;
      reach = std::min(kLongestMove * length, 2.0 * reach);
    } else {
      shooting->restore(last);
      reach = 0.3 * step.norm();
    }
  }
  if (outcome.status.ok()) {
    outcome.status = {Code::kNotConverged, "no end point was found at which the cable carries these forces"};
  }
  return outcome;
}

// Problem 1 of a cable of few bending layers: every equilibrium under the forces is a start angle at A whose shot
// ends without moment, so all of them are found by looking around. The first sagging one is taken.
SolveOutcome scanStartAngles(const CableProperties& cable, double length, const ForcesAtA& forces,
                             const SolveLimits& limits, MultipleShooting* shooting) {
  const auto momentAtB = [&](double angle) {
    return shooting->startFromAngle(cable, length, forces.horizontal, forces.vertical, angle, kScanTolerance);
  };
  SolveOutcome outcome;
  outcome.status = {Code::kNotConverged, "no sagging shape of the cable carries these forces"};
  double angle = -M_PI;
  std::optional<double> moment = momentAtB(angle);
  for (int i = 1; i <= kScanAngles && outcome.status.code == Code::kNotConverged; ++i) {
    if (SolveLimits::Clock::now() > limits.deadline) {
      outcome.status = {Code::kTimedOut, "the time allowed ran out while looking for the cable's angle at A"};
      break;
    }
    const double last_angle = angle;
    const std::optional<double> last_moment = moment;
    angle = -M_PI + 2.0 * M_PI * i / kScanAngles;
    moment = momentAtB(angle);
    if (last_moment && moment && (*last_moment < 0.0) != (*moment < 0.0)) {
      double low = last_angle;
      double high = angle;
      for (int k = 0; k < kScanBisections; ++k) {
        const double middle = 0.5 * (low + high);
        const std::optional<double> there = momentAtB(middle);
        if (!there) break;
        ((*there < 0.0) == (*last_moment < 0.0) ? low : high) = middle;
      }
      if (!shooting->startFromAngle(cable, length, forces.horizontal, forces.vertical, 0.5 * (low + high),
                                    limits.tolerance)) {
        continue;
      }
      const SolveOutcome local =
          newton({Goal::kForces, length, {forces.horizontal, forces.vertical}}, limits, kMaxNewtonIterations, shooting);
      outcome.count(local);
      const bool found = local.status.ok() && shooting->end().position.x() >= 0.0 && onSaggingBranch(*shooting);
      if (found || local.status.code == Code::kTimedOut) outcome.status = local.status;
    }
  }
  return outcome;
}

// Problem 1 of a loop: pulled open by more horizontal force it bends as gently as its catenary; the force is then
// lowered to that asked for.
SolveOutcome closeLoop(const CableProperties& cable, double length, const ForcesAtA& forces, const SolveLimits& limits,
                       MultipleShooting* shooting) {
  const double open = std::cbrt(cable.bending_stiffness * cable.weight * cable.weight / kSafeBend);
  shooting->start(cable, length, open, forces.vertical, limits.tolerance);
  SolveOutcome outcome = followBendingPosition(length, {open, forces.vertical}, limits, shooting);
  MultipleShooting last = *shooting;
  double share = 0.0;
  double step = 0.25;
  for (int i = 0; i < kMaxLoopSteps && outcome.status.ok() && share < 1.0; ++i) {
    const double next = std::min(1.0, share + step);
    const ForcesAtA at{open + next * (forces.horizontal - open), forces.vertical};
    const SolveOutcome local = followBendingPosition(length, at, limits, shooting);
    outcome.count(local);
    if (local.status.code == Code::kTimedOut) outcome.status = local.status;
    if (local.status.ok() && shooting->end().position.x() >= -1e-12 * length && onSaggingBranch(*shooting)) {
      last = *shooting;
      share = next;
      step *= 1.7;
    } else {
      shooting->restore(last);
      step *= 0.4;
    }
  }
  if (outcome.status.ok() && share < 1.0) {
    outcome.status = {Code::kNotConverged, "the loop could not be closed to the horizontal force asked for"};
  }
  return outcome;
}

// Problem 1 through problem 2, from several end points in turn: a strut, nearly straight, if the cable is
// pushed hard; loops whose legs share the weight, from wide to narrow.
SolveOutcome searchEndOfForces(const CableProperties& cable, double length, const ForcesAtA& forces,
                               const SolveLimits& limits, MultipleShooting* shooting) {
  std::vector<Eigen::Vector2d> starts;
  const double buckling = cable.bending_stiffness * std::pow(M_PI / length, 2);
  const Eigen::Vector2d push(-forces.horizontal, forces.vertical - 0.5 * cable.weight * length);
  if (forces.horizontal < 0.0 && push.norm() > kStrutShare * buckling) {
    for (const double share : {0.97, 0.99, 0.999, 0.93, 0.85, 0.7})
      starts.emplace_back(share * length * push.normalized());
  }
  const double balance = cable.weight > 0.0 ? length - 2.0 * forces.vertical / cable.weight : 0.0;
  const double height = std::clamp(balance, -0.98 * length, 0.98 * length);
  for (const double share : {0.5, 0.9, 0.98, 0.2, 0.05, 0.01}) {
    starts.emplace_back(share * std::sqrt(length * length - height * height), height);
  }
  SolveOutcome outcome;
  for (const Eigen::Vector2d& start : starts) {
    outcome.then(moveEndToForces(cable, length, forces, start, limits, shooting));
    if (outcome.status.ok() || outcome.status.code == Code::kTimedOut) break;
  }
  return outcome;
}

}  // namespace

SolveOutcome followBendingPosition(double length, const ForcesAtA& forces, const SolveLimits& limits,
                                   MultipleShooting* shooting) {
  return newton({Goal::kForces, length, {forces.horizontal, forces.vertical}}, limits, kMaxNewtonIterations, shooting);
}

SolveOutcome solveBendingPosition(const CableProperties& cable, double length, const ForcesAtA& forces,
                                  const SolveLimits& limits, MultipleShooting* shooting) {
  SolveOutcome outcome;
  if (pullsAllAlong(cable, length, forces) && sharpestBend(cable, length, forces) < kSharpBend) {
    shooting->start(cable, length, forces.horizontal, forces.vertical, limits.tolerance);
    outcome.then(followBendingPosition(length, forces, limits, shooting));
    if (outcome.status.code == Code::kTimedOut || (outcome.status.ok() && onSaggingBranch(*shooting))) return outcome;
  }
  const double force = std::max(std::hypot(forces.horizontal, forces.vertical),
                                std::hypot(forces.horizontal, forces.vertical - cable.weight * length));
  if (length * std::sqrt(force / cable.bending_stiffness) < kScanLayers) {
    outcome.then(scanStartAngles(cable, length, forces, limits, shooting));
    if (outcome.status.code != Code::kNotConverged) return outcome;
  }
  if (forces.vertical > 0.0 && forces.vertical < cable.weight * length) {
    outcome.then(closeLoop(cable, length, forces, limits, shooting));
    if (outcome.status.code != Code::kNotConverged) return outcome;
  }
  outcome.then(searchEndOfForces(cable, length, forces, limits, shooting));
  return outcome;
}

}  // namespace cdpr_kinetostatics

// Problem 1: from forces to the end point.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "cable/bending_newton.h"
#include "cable/bending_path.h"
#include "cable/bending_vertical.h"
#include "cable/rope_on_pulley.h"
#include "cable/tautness.h"

namespace cdpr_kinetostatics {
namespace {

// Moves of the end point while problem 1 is solved through problem 2: at most so many; their longest and shortest, as
// shares of the length; how a move grows after success and shrinks after failure.
constexpr int kMaxMoves = 60;
constexpr double kLongestMove = 0.1;
constexpr double kShortestMove = 1e-9;
constexpr double kMoveGrowth = 2.0;
constexpr double kMoveShrinking = 0.3;
// A move has failed if the missing force grows by more than this.
constexpr double kMostMissingGrowth = 2.0;
// The rest is left to Newton's method on the nodes under the forces asked for, from this share of the forces on.
constexpr double kNearForces = 1e-3;

// Ends that problem 1 starts from, as shares of the length. A compressed cable is taken for a strut rather than for a
// loop from this share of the buckling load on.
constexpr double kStrutShare = 0.3;
constexpr double kStrutLengths[] = {0.97, 0.99, 0.999, 0.93, 0.85, 0.7};
constexpr double kLoopWidths[] = {0.5, 0.9, 0.98, 0.2, 0.05, 0.01};
constexpr double kHighestLoop = 0.98;

// Problem 1 by a single shot from every angle at A: up to this many bending layers, beyond which a shot amplifies
// the errors of its start too much; with so many angles, and so many bisections where the moment at B changes sign, to
// 1e-5 rad, from where Newton's method converges.
constexpr double kScanLayers = 8.0;
constexpr int kScanAngles = 90;
constexpr int kScanBisections = 12;
constexpr double kScanTolerance = 1e-6;  // relative, of the integration

// Steps of the path on which a loop is closed.
constexpr int kMaxLoopSteps = 40;

Eigen::Vector2d missingForce(const ForcesAtA& forces, const MultipleShooting& shooting) {
  return {forces.horizontal - shooting.horizontalForce(), forces.vertical - shooting.verticalForceA()};
}

// The end lies in front of A, x >= 0, but for rounding [share of L]. Under a push it may lie behind A by no more than
// forces of five digits are known to: the answer for an end straight below A must not turn over when these are rounded.
constexpr double kBehindByRounding = 1e-12;
constexpr double kBehindUnderPush = 1e-5;

bool isInFront(const MultipleShooting& shooting) {
  const double behind = shooting.horizontalForce() < 0.0 ? kBehindUnderPush : kBehindByRounding;
  return shooting.end().position.x() >= -behind * shooting.length();
}

// Moves the end point from a start until the forces are those asked for.
SolveOutcome moveEndToForces(const CableProperties& cable, double length, const ForcesAtA& forces, Eigen::Vector2d end,
                             const SolveLimits& limits, MultipleShooting* shooting) {
  SolveOutcome outcome = solveBendingForces(cable, length, end.x(), end.y(), limits, shooting);
  const double scale = std::max(std::hypot(forces.horizontal, forces.vertical), cable.weight * length);
  double reach = kLongestMove * length;
  for (int i = 0; i < kMaxMoves && outcome.status.ok(); ++i) {
    const Eigen::Vector2d missing = missingForce(forces, *shooting);
    if (missing.norm() <= kNearForces * scale) {
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
    if (local.status.ok() && missingForce(forces, *shooting).norm() <= kMostMissingGrowth * missing.norm()) {
      end += step;
      reach = std::min(kLongestMove * length, kMoveGrowth * reach);
    } else {
      shooting->restore(last);
      reach = kMoveShrinking * step.norm();
    }
  }
  if (outcome.status.ok()) {
    outcome.status = {Code::kNotConverged, "no end point was found at which the cable carries these forces"};
  }
  return outcome;
}

// Problem 1 of a cable of few bending layers: every equilibrium under the forces is a start angle at A whose shot
// ends without moment, so all of them are found by looking around. The first sagging one is taken.
class AngleScan {
 public:
  AngleScan(const CableProperties& cable, double length, const ForcesAtA& forces, const SolveLimits& limits,
            MultipleShooting* shooting)
      : cable_(cable), length_(length), forces_(forces), limits_(limits), shooting_(shooting) {}

  SolveOutcome run() {
    SolveOutcome outcome;
    outcome.status = {Code::kNotConverged, "no sagging shape of the cable carries these forces"};
    double angle = -M_PI;
    std::optional<double> moment = momentAtB(angle, kScanTolerance);
    for (int i = 1; i <= kScanAngles && outcome.status.code == Code::kNotConverged; ++i) {
      if (SolveLimits::Clock::now() > limits_.deadline) {
        outcome.status = {Code::kTimedOut, "the time allowed ran out while looking for the cable's angle at A"};
        break;
      }
      const double last_angle = angle;
      const std::optional<double> last_moment = moment;
      angle = -M_PI + 2.0 * M_PI * i / kScanAngles;
      moment = momentAtB(angle, kScanTolerance);
      if (!last_moment || !moment || (*last_moment < 0.0) == (*moment < 0.0)) continue;
      if (!momentAtB(whereMomentVanishes(last_angle, angle, *last_moment), limits_.tolerance)) continue;
      const SolveOutcome local = followBendingPosition(length_, forces_, limits_, shooting_);
      outcome.count(local);
      const bool found = local.status.ok() && isInFront(*shooting_) && onSaggingBranch(*shooting_);
      if (found || local.status.code == Code::kTimedOut) outcome.status = local.status;
    }
    return outcome;
  }

 private:
  // Empty if the shot was rejected.
  std::optional<double> momentAtB(double angle, double tolerance) const {
    return shooting_->startFromAngle(cable_, length_, forces_.horizontal, forces_.vertical, angle, tolerance,
                                     limits_.deadline);
  }

  // Bisection between two angles at A, at the first of which the moment at B is this one and at the other of the
  // opposite sign.
  double whereMomentVanishes(double low, double high, double moment_at_low) const {
    for (int k = 0; k < kScanBisections; ++k) {
      const double middle = 0.5 * (low + high);
      const std::optional<double> there = momentAtB(middle, kScanTolerance);
      if (!there) break;
      ((*there < 0.0) == (moment_at_low < 0.0) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  const CableProperties& cable_;
  const double length_;
  const ForcesAtA& forces_;
  const SolveLimits& limits_;
  MultipleShooting* const shooting_;
};

// Problem 1 of a loop: pulled open by more horizontal force it bends as gently as its catenary; the force is then
// lowered to that asked for.
SolveOutcome closeLoop(const CableProperties& cable, double length, const ForcesAtA& forces, const SolveLimits& limits,
                       MultipleShooting* shooting) {
  const double open = std::cbrt(cable.bending_stiffness * cable.weight * cable.weight / kSafeBend);
  shooting->start(cable, length, open, forces.vertical, limits.tolerance);
  const SolveOutcome outcome = followBendingPosition(length, {open, forces.vertical}, limits, shooting);
  if (!outcome.status.ok()) return outcome;
  return followPath(
      outcome, kMaxLoopSteps, "the loop could not be closed to the horizontal force asked for",
      [&](double share) {
        const ForcesAtA at{open + share * (forces.horizontal - open), forces.vertical};
        SolveOutcome local = followBendingPosition(length, at, limits, shooting);
        if (local.status.ok() && !(isInFront(*shooting) && onSaggingBranch(*shooting))) {
          local.status = {Code::kWrongBranch, "the loop turned over"};
        }
        return local;
      },
      shooting);
}

// Problem 1 through problem 2, from several end points in turn: a strut, nearly straight, if the cable is
// pushed hard; loops whose legs share the weight, from wide to narrow.
SolveOutcome searchEndOfForces(const CableProperties& cable, double length, const ForcesAtA& forces,
                               const SolveLimits& limits, MultipleShooting* shooting) {
  std::vector<Eigen::Vector2d> starts;
  const double buckling = bucklingForce(cable, length);
  const Eigen::Vector2d push(-forces.horizontal, forces.vertical - 0.5 * cable.weight * length);
  if (forces.horizontal < 0.0 && push.norm() > kStrutShare * buckling) {
    for (const double share : kStrutLengths) starts.emplace_back(share * length * push.normalized());
  }
  const double balance = cable.weight > 0.0 ? length - 2.0 * forces.vertical / cable.weight : 0.0;
  const double height = std::clamp(balance, -kHighestLoop * length, kHighestLoop * length);
  for (const double share : kLoopWidths) {
    starts.emplace_back(share * std::sqrt(length * length - height * height), height);
  }
  SolveOutcome outcome;
  for (const Eigen::Vector2d& start : starts) {
    outcome.then(moveEndToForces(cable, length, forces, start, limits, shooting));
    if (outcome.status.ok() || outcome.status.code == Code::kTimedOut) break;
  }
  return outcome;
}

// From the catenary under the same forces, where that is a start.
SolveOutcome startFromCatenary(const CableProperties& cable, double length, const ForcesAtA& forces,
                               const SolveLimits& limits, MultipleShooting* shooting) {
  if (!pullsAllAlong(cable, length, forces) || sharpestBend(cable, length, forces) >= kSharpBend) {
    return {{Code::kNotConverged, "the catenary under these forces is no start for a cable that bends"}};
  }
  shooting->start(cable, length, forces.horizontal, forces.vertical, limits.tolerance);
  SolveOutcome outcome = followBendingPosition(length, forces, limits, shooting);
  if (outcome.ok() && !onSaggingBranch(*shooting)) {
    outcome.status = {Code::kNotConverged, "the catenary under these forces leads to another equilibrium"};
  }
  return outcome;
}

// All starts, in turn.
SolveOutcome searchPosition(const CableProperties& cable, double length, const ForcesAtA& forces,
                            const SolveLimits& limits, MultipleShooting* shooting) {
  SolveOutcome outcome = startFromCatenary(cable, length, forces, limits, shooting);
  if (outcome.ok() || outcome.status.code == Code::kTimedOut) return outcome;
  const double force =
      std::max(forces.tension(), std::hypot(forces.horizontal, forces.vertical - cable.weight * length));
  if (!hasPulley(cable) && length * std::sqrt(force / cable.bending_stiffness) < kScanLayers) {
    outcome.then(AngleScan(cable, length, forces, limits, shooting).run());
    if (outcome.status.code != Code::kNotConverged) return outcome;
  }
  if (forces.vertical > 0.0 && forces.vertical < cable.weight * length) {
    outcome.then(closeLoop(cable, length, forces, limits, shooting));
    if (outcome.status.code != Code::kNotConverged) return outcome;
  }
  if (hasPulley(cable)) {  // which holds no rope that pushes
    if (isTooStiff(cable, forces)) outcome.status = mayLiftOff(cable.pulley);
    return outcome;
  }
  outcome.then(searchEndOfForces(cable, length, forces, limits, shooting));
  return outcome;
}

}  // namespace

SolveOutcome followBendingPosition(double length, const ForcesAtA& forces, const SolveLimits& limits,
                                   MultipleShooting* shooting) {
  return newton({Goal::kForces, length, {forces.horizontal, forces.vertical}}, limits, kMaxNewtonIterations, shooting);
}

SolveOutcome solveBendingPosition(const CableProperties& cable, double length, const ForcesAtA& forces,
                                  const SolveLimits& limits, MultipleShooting* shooting) {
  const auto search = [&](const ForcesAtA& under) { return searchPosition(cable, length, under, limits, shooting); };
  if (hasPulley(cable) || !isNextToVertical(cable, length, forces)) return search(forces);
  SolveOutcome outcome = startFromCatenary(cable, length, forces, limits, shooting);
  if (outcome.ok() || outcome.status.code == Code::kTimedOut) return outcome;
  outcome.then(standStraight(cable, length, forces, limits, shooting));
  if (outcome.ok() || outcome.status.code == Code::kTimedOut) return outcome;
  outcome.then(lowerHorizontalForce(cable, length, forces, limits, shooting, search));
  return outcome;
}

}  // namespace cdpr_kinetostatics

#include "cable/bending_vertical.h"

#include <algorithm>
#include <cmath>

#include "cable/bending_newton.h"
#include "cable/tautness.h"

namespace cdpr_kinetostatics {
namespace {

// Horizontal forces below this share of the larger tension are next to zero.
constexpr double kNextToZero = 1e-9;

// The small force that pulls, as a share of the larger tension, and the least before zero. It is lowered by a factor
// from step to step, a gentler one (its root) each time the cable does not follow, up to the gentlest.
constexpr double kSmallPull = 1e-4;
constexpr double kLeastPull = 1e-13;
constexpr double kLowering = 1e-2;
constexpr double kGentlestLowering = 0.7;

// From this share of the larger tension on the answer holds whether or not the cable follows farther: the force has
// been met to the accuracy of a solve. A stiff bar whose ends carry half of the weight each is in equilibrium in every
// direction, and Newton's method soon has nothing to go by; what is left of the pull does nothing to it from the other
// share, of its buckling load, on.
constexpr double kMetFrom = 1.1e-8;
constexpr double kMetByBar = 1e-6;

// A cable that follows moves its end by less than this share of its length in one step.
constexpr double kFollowed = 0.02;

bool isBalanced(const CableProperties& cable, double length, const ForcesAtA& forces) {
  const double half_weight = 0.5 * cable.weight * length;
  return std::abs(forces.vertical - half_weight) <= kNextToZero * half_weight;
}

double largerTension(const CableProperties& cable, double length, const ForcesAtA& forces) {
  return std::max(forces.tension(), std::hypot(forces.horizontal, forces.vertical - cable.weight * length));
}

}  // namespace

bool isNextToVertical(const CableProperties& cable, double length, const ForcesAtA& forces) {
  const double tension = largerTension(cable, length, forces);
  return tension > 0.0 && forces.horizontal >= -kVerticalRounding * tension &&
         forces.horizontal <= kNextToZero * tension;
}

SolveOutcome standStraight(const CableProperties& cable, double length, const ForcesAtA& forces,
                           const SolveLimits& limits, MultipleShooting* shooting) {
  SolveOutcome outcome{{Code::kNotConverged, "the cable does not stand straight under these forces"}};
  if (isBalanced(cable, length, forces)) return outcome;
  const double angle = forces.vertical > 0.5 * cable.weight * length ? -M_PI_2 : M_PI_2;
  shooting->startAlong(cable, length, forces, angle, limits.tolerance);
  const SolveOutcome straight = followBendingPosition(length, forces, limits, shooting);
  outcome.count(straight);
  const bool stands = straight.ok() && shooting->stableWithFreeEnd() && onSaggingBranch(*shooting) &&
                      shooting->end().position.y() * angle > 0.0;
  if (stands || straight.status.code == Code::kTimedOut) outcome.status = straight.status;
  return outcome;
}

SolveOutcome lowerHorizontalForce(const CableProperties& cable, double length, const ForcesAtA& forces,
                                  const SolveLimits& limits, MultipleShooting* shooting,
                                  const std::function<SolveOutcome(const ForcesAtA&)>& solve) {
  const double tension = largerTension(cable, length, forces);
  SolveOutcome outcome = solve({kSmallPull * tension, forces.vertical});
  double share = kSmallPull;
  double lowering = kLowering;
  const double by_bar = isBalanced(cable, length, forces) ? kMetByBar * shooting->bucklingForce() : 0.0;
  const double met = std::max(kMetFrom * tension, by_bar);
  while (outcome.ok() && share > 0.0) {
    const MultipleShooting last = *shooting;
    const double next = lowering * share >= kLeastPull ? lowering * share : 0.0;
    const double pull = std::max(next * tension, forces.horizontal);
    const SolveOutcome local = followBendingPosition(length, {pull, forces.vertical}, limits, shooting);
    outcome.count(local);
    const bool follows = local.ok() && onSaggingBranch(*shooting) &&
                         (shooting->end().position - last.end().position).norm() <= kFollowed * length;
    if (!follows) {
      shooting->restore(last);
      if (local.status.code == Code::kTimedOut) outcome.status = local.status;
      lowering = std::sqrt(lowering);
      if (!outcome.ok() || share * tension <= met) break;
      if (lowering <= kGentlestLowering) continue;
      outcome.status = {Code::kNotConverged, "the cable does not follow to a horizontal force as small as this"};
      break;
    }
    share = pull > forces.horizontal ? next : 0.0;
  }
  return outcome;
}

}  // namespace cdpr_kinetostatics

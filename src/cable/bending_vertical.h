// Problem 1 without horizontal force, and next to that: the answer is the limit H -> 0+ (docs/theory.md section 3,
// "Which equilibrium").
//
// A straight cable along the vertical is an equilibrium for H = 0 whatever V is, and so, where V = q L/2, is a stiff
// bar in any direction. Which of them is reached must not depend on how zero is rounded.
#pragma once

#include <functional>

#include "cable/forces_at_a.h"
#include "cable/multiple_shooting.h"
#include "cable/solve_outcome.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

// H is zero, but for a share of the forces that no sensor resolves, and does not push.
bool isNextToVertical(const CableProperties& cable, double length, const ForcesAtA& forces);

// The straight cable that hangs from the end that carries more of the weight. It is the limit where it is stable with
// its other end free: then it moves as little as H does. NOT_CONVERGED where it is not.
SolveOutcome standStraight(const CableProperties& cable, double length, const ForcesAtA& forces,
                           const SolveLimits& limits, MultipleShooting* shooting);

// Solves problem 1 under a small horizontal force that pulls, and lowers this to the one asked for, as long as the
// cable follows. `solve` is problem 1 under any forces.
SolveOutcome lowerHorizontalForce(const CableProperties& cable, double length, const ForcesAtA& forces,
                                  const SolveLimits& limits, MultipleShooting* shooting,
                                  const std::function<SolveOutcome(const ForcesAtA&)>& solve);

}  // namespace cdpr_kinetostatics

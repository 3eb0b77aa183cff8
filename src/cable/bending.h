// Problems 1 and 2 of the cable with flexural rigidity, and the choice among its equilibria.
//
// A cable with EI > 0 can have several equilibria between the same ends: the sagging one, an arch in
// compression, loops. The answer is the stable one that hangs below its chord, the one that the sagging
// catenary turns into as EI grows from 0; a converged residual alone is no proof of it. It is looked for
// from the catenary, checked (stability, side of the chord, loops) and, if the check fails, reached by raising EI
// from a value at which the catenary holds (docs/theory.md section 3, "Which equilibrium").
#pragma once

#include "cable/forces_at_a.h"
#include "cable/multiple_shooting.h"
#include "cable/solve_outcome.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

// True for the equilibrium described above: stable with its ends held, below its chord, free of loops.
bool onSaggingBranch(const MultipleShooting& shooting);

// Problem 2; x >= 0. On success shooting holds the equilibrium, linearised.
SolveOutcome solveBendingForces(const CableProperties& cable, double length, double x, double y,
                                const SolveLimits& limits, MultipleShooting* shooting);

// Problem 2 from the equilibrium that shooting holds, for an end point or a length nearby: Newton's method
// alone, no search. NOT_CONVERGED if the step was too far, WRONG_BRANCH if it led elsewhere.
SolveOutcome followBendingForces(double length, double x, double y, const SolveLimits& limits,
                                 MultipleShooting* shooting);

// Problem 1. For H < 0 the end point is that with x >= 0: a slack loop or a bowed strut.
SolveOutcome solveBendingPosition(const CableProperties& cable, double length, const ForcesAtA& forces,
                                  const SolveLimits& limits, MultipleShooting* shooting);

// Problem 1 from the equilibrium that shooting holds, for forces or a length nearby.
SolveOutcome followBendingPosition(double length, const ForcesAtA& forces, const SolveLimits& limits,
                                   MultipleShooting* shooting);

}  // namespace cdpr_kinetostatics

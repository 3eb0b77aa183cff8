// Continuation: leads a bending cable in steps from a problem that is easy to solve to the one asked for.
#pragma once

#include <functional>

#include "cable/multiple_shooting.h"
#include "cable/solve_outcome.h"

namespace cdpr_kinetostatics {

// Where the easy problem is share 0 and the one asked for is share 1: solves the problem at a share from what shooting
// holds, that of a smaller share. CONVERGED only if the equilibrium is one that may be gone on from.
using SolveAtShare = std::function<SolveOutcome(double share)>;

// shooting holds the equilibrium at share 0, which `start` tells of. Failed steps are tried again from the last
// equilibrium, shorter. Returns the work of start and path; `lost` is said if the path ends before share 1.
SolveOutcome followPath(const SolveOutcome& start, int max_steps, const char* lost, const SolveAtShare& solve,
                        MultipleShooting* shooting);

}  // namespace cdpr_kinetostatics

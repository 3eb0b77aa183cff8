// How a search for an equilibrium ended and what it did before: whatever in this folder iterates returns one of these.
// A bool is left to predicates, and to functions that say whether something can be evaluated where it is.
#pragma once

#include "cdpr_kinetostatics/cable/report.h"

namespace cdpr_kinetostatics {

struct SolveOutcome {
  Status status;
  int iterations = 0;

  // What was left at the last iteration, whether it converged or not; 0 where nothing was evaluated.
  double closure_residual = 0.0;  // distance of the end from the one asked for [m]
  double moment_residual = 0.0;   // largest moment defect [N m]

  bool ok() const { return status.ok(); }

  // Counts the work of a part of this search, whose status is not yet that of the whole.
  void count(const SolveOutcome& part) {
    if (part.iterations == 0) return;
    iterations += part.iterations;
    closure_residual = part.closure_residual;
    moment_residual = part.moment_residual;
  }

  // The search went on like this, and so it stands now.
  void then(const SolveOutcome& next) {
    count(next);
    status = next.status;
  }
};

}  // namespace cdpr_kinetostatics

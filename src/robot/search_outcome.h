// How a search for a robot's equilibrium ended. Every search of this layer answers with one of these; a plain bool is
// left to predicates and to "can this be evaluated here?".
#pragma once

#include "cdpr_kinetostatics/cable/report.h"

namespace cdpr_kinetostatics {

// How far a state of the robot is from equilibrium.
struct Residuals {
  double closure = 0.0;  // largest distance of a cable's end from its attachment [m]
  double force = 0.0;    // norm of the unbalanced force [N]
  double moment = 0.0;   // norm of the unbalanced moment about the platform's origin [N m]; 0 for a point mass
};

struct SearchOutcome {
  Status status;
  int iterations = 0;
  // Of the last state that could be evaluated, also where the search failed; zero if there was none.
  Residuals residuals;

  bool ok() const { return status.ok(); }
};

}  // namespace cdpr_kinetostatics

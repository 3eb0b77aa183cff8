// The catenary: models CATENARY_INEXTENSIBLE and CATENARY, and those that bend where EI = 0. In closed form
// (catenary.h).
#pragma once

#include "cable/closed_form_cable.h"
#include "cable/forces_at_a.h"
#include "cable/solve_outcome.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

class CatenaryCable : public ClosedFormCable {
 public:
  using ClosedFormCable::ClosedFormCable;

  SolveOutcome startUnder(double length, const ForcesAtA& forces, const SolveLimits& limits);
  // The answer is found from anywhere: following it would save nothing.
  SolveOutcome startBetween(double length, double x, double y, const SolveLimits& limits);
  SolveOutcome followBetween(double length, double x, double y, const SolveLimits& limits) {
    return startBetween(length, x, y, limits);
  }

  bool linearise(bool adapt);

  CableSolution describe(double x, double y, int profile_points) const;
};

// The measures that a catenary has, the corrected one as well; `end` is where the cable ends. No profile.
CableSolution catenaryMeasures(const ClosedFormCable& cable, const EndPoint& end);

// The catenary at unstrained arc length s.
ProfilePoint catenaryPoint(const CableProperties& cable, const ForcesAtA& forces, double s);

// Why a catenary has no end under these forces, or CONVERGED: it cannot push, and needs a load.
Status catenaryRefusal(const CableProperties& cable, const ForcesAtA& forces);

}  // namespace cdpr_kinetostatics

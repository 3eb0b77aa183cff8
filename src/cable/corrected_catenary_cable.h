// The catenary with the effect of bending to first order, equation (24) of docs/theory.md: CATENARY_CORRECTED of a
// cable with bending stiffness.
#pragma once

#include "cable/closed_form_cable.h"
#include "cable/forces_at_a.h"
#include "cable/solve_outcome.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/end_point.h"
#include "cdpr_kinetostatics/cable/report.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

// Catenary plus first-order effect; the catenary itself if EI = 0. Needs what firstOrderBending needs.
EndPoint correctedCatenaryEnd(const CableProperties& cable, double horizontal_force, double vertical_force_a,
                              double length);

// Bending is so small that its first-order effect describes it; else the sentence. The cable begins at an eyelet.
Status checkFirstOrder(const CableProperties& cable, double length, const ForcesAtA& forces);

class CorrectedCatenaryCable : public ClosedFormCable {
 public:
  using ClosedFormCable::ClosedFormCable;

  SolveOutcome startUnder(double length, const ForcesAtA& forces, const SolveLimits& limits);

  // By Newton's method from the catenary's forces, which are nearby wherever the correction is worth anything.
  SolveOutcome startBetween(double length, double x, double y, const SolveLimits& limits);
  SolveOutcome followBetween(double length, double x, double y, const SolveLimits& limits) {
    return startBetween(length, x, y, limits);
  }

  bool linearise(bool adapt);

  CableSolution describe(double x, double y, int profile_points) const;

 private:
  // Without curvature there is nothing to correct.
  bool isStraight() const;
  ProfilePoint pointAt(double s) const;
};

}  // namespace cdpr_kinetostatics

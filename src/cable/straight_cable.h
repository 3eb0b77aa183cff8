// The straight cable: models STRAIGHT and STRAIGHT_ELASTIC, half the cable's weight lumped at each end.
//
// It is the weightless catenary under the line's own force (H, V - q L/2) (docs/theory.md section 2). An infinite axial
// stiffness gives the inextensible line, whose tension does not follow from its geometry.
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

// Problem 1. Needs a tension: (H, V - q L/2) must not be zero.
EndPoint straightEnd(const CableProperties& cable, double horizontal_force, double vertical_force_a, double length);

// Problem 2 with tension EA (chord/L - 1), none when the chord is shorter than L. EA must be finite.
ForcesAtA straightForces(const CableProperties& cable, double length, double x, double y);

// What problem 2 says of an inextensible line.
Status inextensibleRefusal(double length, double chord, double tolerance);

class StraightCable : public ClosedFormCable {
 public:
  using ClosedFormCable::ClosedFormCable;

  SolveOutcome startUnder(double length, const ForcesAtA& forces, const SolveLimits& limits);

  // A slack line has an answer, no tension, but no derivatives: it cannot be linearised.
  SolveOutcome startBetween(double length, double x, double y, const SolveLimits& limits);
  SolveOutcome followBetween(double length, double x, double y, const SolveLimits& limits) {
    return startBetween(length, x, y, limits);
  }

  // Problem 3 of an inextensible line, whose length is its chord: the forces of the line that has this tension at A.
  // The least tension that T_A, which carries half of the weight besides, can have is returned if it is less [N].
  SolveOutcome startWithTension(double x, double y, double tension_a, double* least_tension);
  bool lengthIsChord(double x, double y, double tension_a, double length_hint) const;

  // Problem 3 searches up to here: a line that is longer has no tension.
  double longestLength(double chord, double tension_a) const;

  bool linearise(bool adapt);

  // Without tension (x, y) says where the line points.
  CableSolution describe(double x, double y, int profile_points) const;
};

}  // namespace cdpr_kinetostatics

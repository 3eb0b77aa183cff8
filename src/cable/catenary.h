// The elastic catenary in closed form (paper equation (6)), written without cancellation so that it
// holds from a hanging loop to a string, weightless cables included (docs/theory.md section 3).
//
// An infinite axial stiffness gives the inextensible catenary. EI is not looked at.
#pragma once

#include <optional>

#include "cable/forces_at_a.h"
#include "cable/solve_outcome.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/end_point.h"
#include "cdpr_kinetostatics/cable/report.h"

namespace cdpr_kinetostatics {

// Needs T > 0 along the cable: not (H = 0 and 0 <= V <= q L).
EndPoint catenaryEnd(const CableProperties& cable, double horizontal_force, double vertical_force_a, double length);

// x/H [m/N], the horizontal compliance; finite as H -> 0 while the cable is taut.
double catenaryHorizontalCompliance(const CableProperties& cable, double horizontal_force, double vertical_force_a,
                                    double length);

// Slope angle at unstrained arc length s: direction of the force (H, q s - V).
double catenaryAngle(const CableProperties& cable, double horizontal_force, double vertical_force_a, double s);

// Unstrained length plus stretch [m].
double catenaryStrainedLength(const CableProperties& cable, double horizontal_force, double vertical_force_a,
                              double length);

// Whether a catenary of this length spans the chord at all; if not, why.
Status catenaryReach(const CableProperties& cable, double length, double chord);

// Problem 2. The end point is the gradient of the (strictly convex) complementary energy of the force, so a damped
// Newton method finds the one answer from anywhere. x >= 0. Infeasible where there is no answer: an inextensible cable
// not longer than the chord, or a weightless cable that is slack.
SolveOutcome solveCatenaryForces(const CableProperties& cable, double length, double x, double y, ForcesAtA* forces);

// The same for those to whom the catenary is only a start: its forces, if it has any.
std::optional<ForcesAtA> catenaryForces(const CableProperties& cable, double length, double x, double y);

}  // namespace cdpr_kinetostatics

// The elastic catenary in closed form (paper equation (6)), written without cancellation so that it
// holds from a hanging loop to a string, weightless cables included (docs/theory.md section 3).
//
// An infinite axial stiffness gives the inextensible catenary. EI is not looked at.
#pragma once

#include <cmath>
#include <optional>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/end_point.h"

namespace cdpr_kinetostatics {

struct ForcesAtA {
  double horizontal = 0.0;  // H [N]
  double vertical = 0.0;    // V [N]

  // H < 0, by more than the rounding of a vertical cable's.
  bool push() const { return horizontal < -1e-12 * std::abs(vertical); }
};

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

// Problem 2. The end point is the gradient of the (strictly convex) complementary energy of the force, so
// a damped Newton method finds the one answer from anywhere. x >= 0. Empty where there is no answer: an
// inextensible cable not longer than the chord, or a weightless cable that is slack.
std::optional<ForcesAtA> catenaryForces(const CableProperties& cable, double length, double x, double y,
                                        int* iterations = nullptr);

}  // namespace cdpr_kinetostatics

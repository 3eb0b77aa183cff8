// The straight cable: rungs STRAIGHT and STRAIGHT_ELASTIC, half the cable's weight lumped at each end.
//
// It is the weightless catenary under the line's own force (H, V - q L/2). An infinite axial stiffness
// gives the inextensible line.
#pragma once

#include "cable/catenary.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/end_point.h"

namespace cdpr_kinetostatics {

// Problem 1. Needs a tension: (H, V - q L/2) must not be zero.
EndPoint straightEnd(const CableProperties& cable, double horizontal_force, double vertical_force_a, double length);

// Problem 2 with tension EA (chord/L - 1), none when the chord is shorter than L. EA must be finite.
ForcesAtA straightForces(const CableProperties& cable, double length, double x, double y);

}  // namespace cdpr_kinetostatics

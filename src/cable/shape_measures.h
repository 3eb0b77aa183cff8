// What a bending cable looks like: measures and the profile of a chain whose nodes have converged.
#pragma once

#include "cable/segmented_cable.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"

namespace cdpr_kinetostatics {

// Signed area between chord and cable [m^2], positive where the cable lies below its chord.
double areaBelowChord(const SegmentedCable& shape);

// Fills the end point, the angles, the sag, the largest moment and shear, the strained length and, for at least two
// profile points, the profile. Returns the work of the integration between the points where the state is known.
IntegrationWork measureShape(const SegmentedCable& shape, int profile_points, CableSolution* solution);

}  // namespace cdpr_kinetostatics

// What the description of a free part lacks where it comes from a guide pulley or has a dead part.
#pragma once

#include "cable/pulley_end.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"

namespace cdpr_kinetostatics {

// What the description of the free part lacks: it counts from where the rope leaves the pulley, to which the pulley and
// the dead part are added. length is L.
void addHeldRope(const CableProperties& cable, double length, CableSolution* solution);

// The layer at the pulley, which the description of the corrected catenary does not have: that of a cable whose moment
// vanishes where it begins.
void addPulleyLayer(const CableProperties& cable, const PulleyEnd& at, CableSolution* solution);

}  // namespace cdpr_kinetostatics

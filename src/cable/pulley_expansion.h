// What flexural rigidity does to a catenary that comes from a guide pulley: the expansion of bending_expansion.h with
// the pulley's layer (docs/theory.md section 8).
#pragma once

#include "cable/bending_expansion.h"
#include "cable/forces_at_a.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

BendingExpansion pulleyExpansion(const CableProperties& cable, const ForcesAtA& forces, double length);

}  // namespace cdpr_kinetostatics

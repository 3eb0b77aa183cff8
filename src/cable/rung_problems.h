// The three problems of one cable on a given rung of the ladder; cable_solver.h is their public face.
#pragma once

#include "cdpr_kinetostatics/cable/cable_solver.h"

namespace cdpr_kinetostatics {

// As findPosition, findForces and findLength, for any rung but AUTO.
CableSolution positionOnRung(const CableProperties& cable, double length, double horizontal_force,
                             double vertical_force_a, const CableSolverOptions& options);
CableSolution forcesOnRung(const CableProperties& cable, double length, double x, double w,
                           const CableSolverOptions& options);
CableSolution lengthOnRung(const CableProperties& cable, double x, double w, double tension_a, double length_hint,
                           const CableSolverOptions& options);

}  // namespace cdpr_kinetostatics

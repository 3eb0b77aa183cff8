// The three problems of one cable on a given rung of the ladder; cable_solver.h is their public face.
#pragma once

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

struct RungOptions {
  Model model = Model::kBending;
  SolveLimits limits;
  int profile_points = 0;  // 0, or at least 2
};

// As findPosition, findForces and findLength, for any rung but AUTO.
CableSolution positionOnRung(const CableProperties& cable, double length, double horizontal_force,
                             double vertical_force_a, const RungOptions& options);
CableSolution forcesOnRung(const CableProperties& cable, double length, double x, double y, const RungOptions& options);
CableSolution lengthOnRung(const CableProperties& cable, double x, double y, double tension_a, double length_hint,
                           const RungOptions& options);

}  // namespace cdpr_kinetostatics

// The three problems of one cable with a given model; cable_solver.h is their public face. They are written once, on
// top of SaggingCable: none of them asks which model it is.
#pragma once

#include "cable/sagging_cable.h"
#include "cable/shot.h"
#include "cable/solve_outcome.h"
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

// As findPosition, findForces and findLength, for any model but AUTO.
CableSolution positionOnRung(const CableProperties& cable, double length, double horizontal_force,
                             double vertical_force_a, const RungOptions& options);
CableSolution forcesOnRung(const CableProperties& cable, double length, double x, double y, const RungOptions& options);
CableSolution lengthOnRung(const CableProperties& cable, double x, double y, double tension_a, double length_hint,
                           const RungOptions& options);  // rung_length.cpp

// The solution, which describes the cable that a search has found, if it passes the gate (cable_gate.h); otherwise its
// refusal.
CableSolution verifiedCable(const SaggingCable& cable, const SolveOutcome& outcome, const SolveLimits& limits,
                            CableSolution solution);

// What is said of a cable that was not solved: why, and what was done before.
CableSolution refusedCable(Model model, const SolveOutcome& outcome, const IntegrationWork& work = {});

}  // namespace cdpr_kinetostatics

// The three problems of one cable, for every rung of the ladder (paper, section 3).
//
// Inputs are checked: a call never throws, never returns NaN; the outcome is in solution.status.
#pragma once

#include <chrono>
#include <limits>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/model.h"

namespace cdpr_kinetostatics {

struct CableSolverOptions {
  Model model = Model::kBending;

  // AUTO takes the coarsest rung that moves the end B by less than this [m]. Which one it took is in
  // solution.model; in solution.status.message, what that neglects.
  double accuracy = 1e-4;

  // Relative tolerance of the integration; closure is iterated until forces change by less than
  // tolerance times the tension.
  double tolerance = 1e-8;

  // The solve stops with TIMED_OUT when it has taken longer than this [s].
  std::chrono::duration<double> timeout{std::numeric_limits<double>::infinity()};

  int profile_points = 0;  // 0, or at least 2
};

// INVALID_INPUT unless model is AUTO or a rung of the ladder.
Status checkModel(Model model);

// Problem 1: where does the end B lie, the forces at A being known? length > 0 [m]; forces [N].
CableSolution findPosition(const CableProperties& cable, double length, double horizontal_force,
                           double vertical_force_a, const CableSolverOptions& options);

// Problem 2: which forces hold the end B at (x, y), x >= 0 [m]?
CableSolution findForces(const CableProperties& cable, double length, double x, double y,
                         const CableSolverOptions& options);

// Problem 3: how long is the cable that has tension_a [N] at A and its end B at (x, y)? Several
// lengths may answer: the one nearest to length_hint [m] if that is positive, else the shortest.
// INFEASIBLE below the least tension that can hold the cable; the message states it.
CableSolution findLength(const CableProperties& cable, double x, double y, double tension_a, double length_hint,
                         const CableSolverOptions& options);

}  // namespace cdpr_kinetostatics

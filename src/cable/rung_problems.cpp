#include "cable/rung_problems.h"

#include <cmath>
#include <utility>

#include "cable/cable_checks.h"
#include "cable/cable_gate.h"
#include "cable/sagging_cable.h"

namespace cdpr_kinetostatics {

CableSolution refusedCable(Model model, const SolveOutcome& outcome, const IntegrationWork& work) {
  CableSolution solution;
  solution.status = outcome.status;
  solution.model = model;
  solution.iterations = outcome.iterations;
  // A search that diverged leaves residuals that are no numbers.
  if (std::isfinite(outcome.closure_residual)) solution.closure_residual = outcome.closure_residual;
  if (std::isfinite(outcome.moment_residual)) solution.moment_residual = outcome.moment_residual;
  solution.integrator_steps = work.steps;
  solution.evaluations = work.evaluations;
  return solution;
}

CableSolution verifiedCable(const SaggingCable& cable, const SolveOutcome& outcome, const SolveLimits& limits,
                            CableSolution solution) {
  solution.status = verdictOf(cable, solution, limits.tolerance);
  solution.iterations = outcome.iterations;
  if (solution.status.ok()) return solution;
  return refusedCable(solution.model,
                      {solution.status, outcome.iterations, solution.closure_residual, solution.moment_residual},
                      cable.work());
}

CableSolution positionOnRung(const CableProperties& properties, double length, double h, double v,
                             const RungOptions& options) {
  const Status check = firstRefusal(checkCable(properties, options.model), checkLength("length", length),
                                    checkForce("horizontal_force", h), checkForce("vertical_force_a", v));
  if (!check.ok()) return refusedCable(options.model, {check});
  SaggingCable cable(properties, options.model, options.limits.tolerance);
  const SolveOutcome outcome = cable.startUnder(length, {h, v}, options.limits);
  if (!outcome.ok()) return refusedCable(options.model, outcome, cable.work());
  const Eigen::Vector2d end = cable.end().position;
  CableSolution solution = cable.describe(end.x(), end.y(), options.profile_points);
  solution.closure_residual = 0.0;  // no end was asked for
  return verifiedCable(cable, outcome, options.limits, std::move(solution));
}

CableSolution forcesOnRung(const CableProperties& properties, double length, double x, double y,
                           const RungOptions& options) {
  const Status check =
      firstRefusal(checkCable(properties, options.model), checkLength("length", length), checkEnd(x, y));
  if (!check.ok()) return refusedCable(options.model, {check});
  SaggingCable cable(properties, options.model, options.limits.tolerance);
  const SolveOutcome outcome = cable.startBetween(length, x, y, options.limits);
  if (!outcome.ok()) return refusedCable(options.model, outcome, cable.work());
  return verifiedCable(cable, outcome, options.limits, cable.describe(x, y, options.profile_points));
}

}  // namespace cdpr_kinetostatics

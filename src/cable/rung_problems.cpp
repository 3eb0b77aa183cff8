#include "cable/rung_problems.h"

#include <cmath>

#include "cable/cable_checks.h"
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

CableSolution positionOnRung(const CableProperties& properties, double length, double h, double v,
                             const RungOptions& options) {
  const Status check = firstRefusal(checkCable(properties, options.model), checkLength(length),
                                    checkForce("horizontal_force", h), checkForce("vertical_force_a", v));
  if (!check.ok()) return refusedCable(options.model, {check});
  SaggingCable cable(properties, options.model, options.limits.tolerance);
  const SolveOutcome outcome = cable.startUnder(length, {h, v}, options.limits);
  if (!outcome.ok()) return refusedCable(options.model, outcome, cable.work());
  const Eigen::Vector2d end = cable.end().position;
  CableSolution solution = cable.describe(end.x(), end.y(), options.profile_points);
  solution.closure_residual = 0.0;  // no end was asked for
  solution.iterations = outcome.iterations;
  return solution;
}

CableSolution forcesOnRung(const CableProperties& properties, double length, double x, double y,
                           const RungOptions& options) {
  const Status check = firstRefusal(checkCable(properties, options.model), checkLength(length), checkEnd(x, y));
  if (!check.ok()) return refusedCable(options.model, {check});
  SaggingCable cable(properties, options.model, options.limits.tolerance);
  const SolveOutcome outcome = cable.startBetween(length, x, y, options.limits);
  if (!outcome.ok()) return refusedCable(options.model, outcome, cable.work());
  CableSolution solution = cable.describe(x, y, options.profile_points);
  solution.iterations = outcome.iterations;
  return solution;
}

}  // namespace cdpr_kinetostatics

#include "cable/bending_cable.h"

#include <algorithm>
#include <cmath>

#include "cable/cable_description.h"
#include "cable/pulley_description.h"
#include "cable/rope_on_pulley.h"
#include "cable/step_limits.h"
#include "cable/tautness.h"

namespace cdpr_kinetostatics {

void BendingCable::start(double length, const ForcesAtA& forces) {
  shooting_.start(properties_, length, forces.horizontal, forces.vertical, tolerance_);
}

SolveOutcome BendingCable::startUnder(double length, const ForcesAtA& forces, const SolveLimits& limits) {
  return solveBendingPosition(properties_, length, forces, limits, &shooting_);
}

SolveOutcome BendingCable::startBetween(double length, double x, double y, const SolveLimits& limits) {
  return solveBendingForces(properties_, length, x, y, limits, &shooting_);
}

SolveOutcome BendingCable::followBetween(double length, double x, double y, const SolveLimits& limits) {
  SolveOutcome outcome = followBendingForces(length, x, y, limits, &shooting_);
  if (!outcome.ok()) outcome.then(startBetween(length, x, y, limits));
  return outcome;
}

double BendingCable::dampingFor(const Eigen::Vector3d& change) const {
  double damping = std::min(dampingByLength(change, length()), kMaxAngleStep / shooting_.angleChange(change));
  if (length() < kTautExcess * end().position.norm()) {
    damping = std::min(damping, dampingByForce(change, forces().tension()));
  }
  return damping;
}

CableSolution BendingCable::describe(double x, double y, int profile_points) const {
  CableSolution solution = solutionUnder(properties_, freeLength(), forces());
  shooting_.measure(profile_points, &solution);
  if (!beginsAtEyelet(properties_)) addHeldRope(properties_, length(), &solution);
  solution.end_jacobian = end().jacobian;
  solution.force_jacobian = forceJacobian(end());
  solution.moment_residual = shooting_.momentDefect();
  solution.closure_residual += std::hypot(solution.x - x, solution.y - y);
  return solution;
}

}  // namespace cdpr_kinetostatics

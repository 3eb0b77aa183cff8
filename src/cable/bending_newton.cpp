#include "cable/bending_newton.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cable/iteration_schedule.h"
#include "cable/step_limits.h"

namespace cdpr_kinetostatics {
namespace {

// The change of the force is measured against its size, but at least against this share of the cable's buckling load:
// a bar can carry almost no force at all.
constexpr double kLeastForce = 1e-3;

// The end point is met to rounding at this share of the length, some fifty times the rounding of a double.
constexpr double kClosureRounding = 1e-14;

// The change of (H, V, L) that the target asks for after the nodes' own step. residual: of the end point [m].
Eigen::Vector3d changeTowards(const NewtonTarget& target, const MultipleShooting& shooting, double* residual) {
  Eigen::Vector3d change(0.0, 0.0, target.length - shooting.length());
  if (target.goal == Goal::kEndPoint) {
    const Eigen::Matrix<double, 2, 3>& jacobian = shooting.end().jacobian;
    const Eigen::Vector2d defect = target.value - shooting.end().position - jacobian.col(2) * change.z();
    change.head<2>() = jacobian.leftCols<2>().inverse() * defect;
    *residual = defect.norm();
  } else {
    change.head<2>() = target.value - Eigen::Vector2d(shooting.horizontalForce(), shooting.verticalForceA());
  }
  return change;
}

}  // namespace

double sharpestBend(const CableProperties& cable, double length, const ForcesAtA& f) {
  const bool bottom_inside = f.vertical > 0.0 && f.vertical < cable.weight * length;
  const double v = bottom_inside ? 0.0 : std::min(std::abs(f.vertical), std::abs(f.vertical - cable.weight * length));
  const double t = std::hypot(f.horizontal, v);
  const double turn = cable.weight * f.horizontal / (t * t);
  if (t == 0.0) return std::numeric_limits<double>::infinity();
  return cable.bending_stiffness / t * turn * turn;
}

SolveOutcome newton(const NewtonTarget& target, const SolveLimits& limits, int max_iterations,
                    MultipleShooting* shooting) {
  SolveOutcome outcome;
  bool adapt = true;
  double last_size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < max_iterations; ++i) {
    if (SolveLimits::Clock::now() > limits.deadline) {
      outcome.status = {Code::kTimedOut, "the time allowed ran out while joining the cable's segments"};
      return outcome;
    }
    ++outcome.iterations;
    if (!shooting->linearise(adapt, limits.deadline)) break;
    outcome.moment_residual = shooting->momentDefect();
    const Eigen::Vector3d change = changeTowards(target, *shooting, &outcome.closure_residual);
    if (!change.allFinite()) break;
    const double tension = std::max(std::hypot(shooting->horizontalForce(), shooting->verticalForceA()),
                                    kLeastForce * shooting->bucklingForce());
    const double angle = shooting->angleChange(change);
    const double size = std::max(angle, change.head<2>().norm() / tension);
    const double damping = std::min(1.0, kMaxAngleStep / angle);
    const bool at_rounding = outcome.closure_residual <= kClosureRounding * target.length && angle <= limits.tolerance;
    const bool stalled = hasStoppedShrinking(size, last_size);
    if (!adapt && (size <= limits.tolerance || (stalled && at_rounding))) {
      shooting->step(change, damping);
      outcome.status.code = Code::kConverged;
      return outcome;
    }
    shooting->step(change, damping);
    adapt = choosesStepsNext(size, i);
    last_size = size;
  }
  if (limits.haveEnded()) {
    outcome.status = {Code::kTimedOut, "the time allowed ran out while joining the cable's segments"};
    return outcome;
  }
  outcome.status = {Code::kNotConverged,
                    shooting->tooManySegments()
                        ? "the cable bends sharply over too many bending layers to be shot: a catenary is accurate here"
                        : "Newton's method did not join the cable's segments"};
  return outcome;
}

}  // namespace cdpr_kinetostatics

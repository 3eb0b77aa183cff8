// Newton's method on the segments of one bending cable, and how its catenary is judged as a start: what problems 1 and
// 2 (bending.cpp, bending_position.cpp) have in common.
#pragma once

#include <Eigen/Core>

#include "cable/bending.h"

namespace cdpr_kinetostatics {

// Newton's method converges in four to eight iterations from a good start; slack and compressed cables take up to
// thirty while the node angles' steps are damped.
inline constexpr int kMaxNewtonIterations = 40;

// The same for a step along a path, whose start is good or the step too long.
inline constexpr int kMaxFollowIterations = 12;

// (lambda/R)^2 at the sharpest bend, radius R: below the first the catenary is a safe start, since what bending does to
// it is of the order of this number; beyond the second the bending layer is thicker than the bend, and the catenary is
// not tried as a direct start.
inline constexpr double kSafeBend = 0.01;
inline constexpr double kSharpBend = 1.0;

// What the outer problem asks of a Newton iteration.
enum class Goal { kEndPoint, kForces };

struct NewtonTarget {
  Goal goal = Goal::kEndPoint;
  double length = 0.0;
  Eigen::Vector2d value = Eigen::Vector2d::Zero();  // (x, y) or (H, V)
};

// Newton's method on (20) and the nodes, from what shooting holds.
SolveOutcome newton(const NewtonTarget& target, const SolveLimits& limits, int max_iterations,
                    MultipleShooting* shooting);

// (lambda/R)^2 at the point of the catenary that bends most.
double sharpestBend(const CableProperties& cable, double length, const ForcesAtA& f);

}  // namespace cdpr_kinetostatics

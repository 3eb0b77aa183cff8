// Newton's method on the segments of one bending cable, and how its catenary is judged as a start: what problems 1 and
// 2 (bending.cpp, bending_position.cpp) have in common.
#pragma once

#include <Eigen/Core>

#include "cable/bending.h"

namespace cdpr_kinetostatics {

inline constexpr int kMaxNewtonIterations = 40;

// (lambda/R)^2 at the sharpest bend, radius R: below the first the catenary is a safe start, beyond the second it is
// not tried as a direct one.
inline constexpr double kSafeBend = 0.01;
inline constexpr double kSharpBend = 1.0;

// What the outer problem asks of a Newton iteration.
enum class Goal { kEndPoint, kForces };

struct NewtonTarget {
  Goal goal = Goal::kEndPoint;
  double length = 0.0;
  Eigen::Vector2d value = Eigen::Vector2d::Zero();  // (x, y) or (H, V)
};

SolveOutcome newton(const NewtonTarget& target, const SolveLimits& limits, int max_iterations,
                    MultipleShooting* shooting);

// (lambda/R)^2 at the point of the catenary that bends most.
double sharpestBend(const CableProperties& cable, double length, const ForcesAtA& f);

}  // namespace cdpr_kinetostatics

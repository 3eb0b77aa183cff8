// The point of a polytope nearest to a given one: min |x - x0|^2 subject to N^T x >= c.
//
// Dual active set (Goldfarb and Idnani, 1983) for the identity Hessian: starts from the unconstrained
// optimum, adds violated constraints one by one, exact to rounding, and says which constraints contradict
// each other when there is no feasible point. For the few redundant tensions of a robot.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

struct NearestPoint {
  bool feasible = false;
  Eigen::VectorXd x;
  std::vector<int> active;  // constraints that hold with equality; if infeasible, those in contradiction
};

// normals: one column per constraint; tolerance: accepted violation, in the unit of bounds. After the deadline the
// point reached is returned as infeasible.
NearestPoint nearestInPolytope(const Eigen::VectorXd& x0, const Eigen::MatrixXd& normals, const Eigen::VectorXd& bounds,
                               double tolerance,
                               SolveLimits::Clock::time_point deadline = SolveLimits::Clock::time_point::max());

}  // namespace cdpr_kinetostatics

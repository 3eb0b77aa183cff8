// A small quadratic program: min v^T B v/2 + c^T v subject to A v = b and N^T v >= d.
//
// B may be indefinite: where the equations leave a direction of negative curvature free, it counts with the opposite
// sign, so that the step goes downhill. Where the inequalities contradict the equations, the step leaves of them as
// little as the inequalities allow.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

struct QuadraticProgram {
  Eigen::MatrixXd hessian;   // B
  Eigen::VectorXd gradient;  // c
  Eigen::MatrixXd matrix;    // A, rows of comparable size
  Eigen::VectorXd right;     // b
  Eigen::MatrixXd normals;   // N, a column for each inequality
  Eigen::VectorXd bounds;    // d
  Eigen::VectorXd scale;     // of the variables: changes of comparable weight
};

struct QuadraticStep {
  Eigen::VectorXd change;       // v
  Eigen::VectorXd multipliers;  // of the equations; zero if infeasible
  double largest_push = 0.0;    // the largest multiplier of an inequality
  double imbalance = 0.0;       // |A v - b| that no v at all can remove
  bool feasible = false;        // the inequalities can be met
  std::vector<int> active;      // inequalities that hold with equality; if infeasible, those in contradiction
};

QuadraticStep solveQuadraticProgram(const QuadraticProgram& program, SolveLimits::Clock::time_point deadline);

}  // namespace cdpr_kinetostatics

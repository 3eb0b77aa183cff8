// Tensions that balance a wrench, as near as the limits allow to preferred ones.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

// min sum (weight_j (t_j - preferred_j))^2 subject to matrix t = wrench and lower <= t <= upper. Bounds may
// be infinite; weights are positive.
struct TensionProblem {
  Eigen::MatrixXd matrix;  // rows scaled to comparable size
  Eigen::VectorXd wrench;
  Eigen::VectorXd preferred;
  Eigen::VectorXd weight;
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
};

struct TensionDistribution {
  Eigen::VectorXd tensions;
  double imbalance = 0.0;               // |matrix t - wrench| that no tensions at all can remove
  bool feasible = false;                // the limits can be met
  std::vector<int> at_lower, at_upper;  // limits reached; if infeasible, those in contradiction
  Eigen::VectorXd multipliers;          // of the equations, in half of the objective; empty if infeasible
  double largest_push = 0.0;            // the largest multiplier of a limit
};

// After the deadline what has been reached is returned as infeasible. Where the limits cannot be met the tensions are
// those within the limits that leave least of the wrench.
TensionDistribution distributeTensions(const TensionProblem& problem,
                                       SolveLimits::Clock::time_point deadline = SolveLimits::Clock::time_point::max());

// The same by one linear system if exactly these limits are the ones reached, as in a problem that changes little from
// one to the next. Nothing if they are not, or if the tensions cannot act in every direction.
std::optional<TensionDistribution> distributeAtLimits(const TensionProblem& problem, const std::vector<int>& at_lower,
                                                      const std::vector<int>& at_upper);

// Non-negative tensions that balance the wrench as well as possible, of least norm among those.
Eigen::VectorXd nonNegativeTensions(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& wrench);

}  // namespace cdpr_kinetostatics

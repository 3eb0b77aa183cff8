// Tools for the tests of residual blocks: a block's values and Jacobians as matrices, and other ways to
// differentiate it.
#pragma once

#include <ceres/cost_function.h>

#include <Eigen/Core>
#include <vector>

namespace cdpr_kinetostatics {

using ParameterBlocks = std::vector<Eigen::VectorXd>;

struct Evaluation {
  bool valid = false;
  Eigen::VectorXd residuals;
  std::vector<Eigen::MatrixXd> jacobians;  // one per parameter block

  bool finite() const;
};
Evaluation evaluate(const ceres::CostFunction& block, const ParameterBlocks& parameters);

// Jacobians by ceres::GradientChecker (Ridders' extrapolation), with respect to the tangent space of
// ceres::EigenQuaternionManifold for block 1, the orientation; and the block's own ones there.
struct CheckedJacobians {
  bool valid = false;
  std::vector<Eigen::MatrixXd> own, numeric;
};
CheckedJacobians checkedJacobians(const ceres::CostFunction& block, const ParameterBlocks& parameters);

// Jacobian with respect to one parameter block by central differences of sixth order with these steps.
Eigen::MatrixXd differences(const ceres::CostFunction& block, const ParameterBlocks& parameters, std::size_t which,
                            const Eigen::VectorXd& steps);

// Largest difference of two Jacobians' columns, relative to the column's norm or to `least` if that is larger.
double largestDifference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double least);

}  // namespace cdpr_kinetostatics

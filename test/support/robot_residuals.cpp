#include "robot_residuals.h"

#include <ceres/gradient_checker.h>
#include <ceres/manifold.h>

#include <algorithm>

namespace cdpr_kinetostatics {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::vector<const double*> pointers(const ParameterBlocks& parameters) {
  std::vector<const double*> result;
  for (const Eigen::VectorXd& block : parameters) result.push_back(block.data());
  return result;
}

}  // namespace

bool Evaluation::finite() const {
  bool finite = residuals.allFinite();
  for (const Eigen::MatrixXd& jacobian : jacobians) finite = finite && jacobian.allFinite();
  return finite;
}

Evaluation evaluate(const ceres::CostFunction& block, const ParameterBlocks& parameters) {
  Evaluation result;
  result.residuals.setZero(block.num_residuals());
  std::vector<RowMajor> jacobians;
  for (const Eigen::VectorXd& parameter : parameters) {
    jacobians.push_back(RowMajor::Zero(block.num_residuals(), parameter.size()));
  }
  std::vector<double*> outputs;
  for (RowMajor& jacobian : jacobians) outputs.push_back(jacobian.data());
  result.valid = block.Evaluate(pointers(parameters).data(), result.residuals.data(), outputs.data());
  result.jacobians.assign(jacobians.begin(), jacobians.end());
  return result;
}

CheckedJacobians checkedJacobians(const ceres::CostFunction& block, const ParameterBlocks& parameters) {
  const ceres::EigenQuaternionManifold quaternion;
  std::vector<const ceres::Manifold*> manifolds(parameters.size(), nullptr);
  manifolds[1] = &quaternion;
  ceres::NumericDiffOptions options;
  options.ridders_relative_initial_step_size = 1e-3;
  const ceres::GradientChecker checker(&block, &manifolds, options);
  ceres::GradientChecker::ProbeResults results;
  checker.Probe(pointers(parameters).data(), 1e-9, &results);  // how close is judged by the caller
  CheckedJacobians checked;
  checked.valid = results.return_value;
  checked.own.assign(results.local_jacobians.begin(), results.local_jacobians.end());
  checked.numeric.assign(results.local_numeric_jacobians.begin(), results.local_numeric_jacobians.end());
  return checked;
}

Eigen::MatrixXd differences(const ceres::CostFunction& block, const ParameterBlocks& parameters, std::size_t which,
                            const Eigen::VectorXd& steps) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(block.num_residuals(), steps.size());
  constexpr double kWeights[] = {45.0, -9.0, 1.0};
  for (Eigen::Index column = 0; column < steps.size(); ++column) {
    for (int k = 1; k <= 3; ++k) {
      for (const double sign : {1.0, -1.0}) {
        ParameterBlocks moved = parameters;
        moved[which](column) += sign * k * steps(column);
        Eigen::VectorXd residuals(block.num_residuals());
        const bool valid = block.Evaluate(pointers(moved).data(), residuals.data(), nullptr);
        if (!valid) residuals.setConstant(1e300);
        jacobian.col(column) += sign * kWeights[k - 1] / (60.0 * steps(column)) * residuals;
      }
    }
  }
  return jacobian;
}

double largestDifference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double least) {
  double largest = 0.0;
  for (Eigen::Index column = 0; column < a.cols(); ++column) {
    const double size = std::max({a.col(column).norm(), b.col(column).norm(), least});
    largest = std::max(largest, (a - b).col(column).norm() / size);
  }
  return largest;
}

}  // namespace cdpr_kinetostatics

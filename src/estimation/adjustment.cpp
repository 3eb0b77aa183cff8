#include "estimation/adjustment.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

#include "estimation/adjustment_statistics.h"
#include "robot/coupled_newton.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxIterations = 100;

// The selected measurements, in the order of the cost's residuals.
std::vector<Observation> observationsOf(const RobotDescription& robot, const Selection& selection) {
  std::vector<Observation> observations;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    if (selection.lengths[i]) observations.push_back({Observation::Kind::kLength, i});
  }
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    if (selection.tensions[i]) observations.push_back({Observation::Kind::kTension, i});
  }
  for (std::size_t k = 0; selection.load.any() && k < static_cast<std::size_t>(robot.freedoms()); ++k) {
    observations.push_back({Observation::Kind::kLoad, k});
  }
  return observations;
}

Eigen::MatrixXd dense(const ceres::CRSMatrix& sparse) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(sparse.num_rows, sparse.num_cols);
  for (int row = 0; row < sparse.num_rows; ++row) {
    for (int k = sparse.rows[row]; k < sparse.rows[row + 1]; ++k) matrix(row, sparse.cols[k]) = sparse.values[k];
  }
  return matrix;
}

}  // namespace

Adjusted adjust(const RobotDescription& robot, const EstimatorOptions& options, const CableMeasurements& measurements,
                const Selection& selection, const std::vector<Model>& rungs, const RobotForces& start,
                std::chrono::steady_clock::time_point deadline) {
  Adjusted adjusted;
  const double left = std::chrono::duration<double>(deadline - std::chrono::steady_clock::now()).count();
  if (left <= 0.0) {
    adjusted.status = {Code::kTimedOut, "the time allowed ran out before the pose was estimated"};
    return adjusted;
  }
  Eigen::Vector3d position = start.pose.position;
  Eigen::Quaterniond orientation = start.pose.orientation;
  std::vector<double> densities;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot.cables[i], start.pose);
    densities.push_back(start.forces[i].horizontal / distanceBeside(plane.x, start.lengths[i]));
  }
  const bool rigid = robot.type == PlatformType::kRigidBody;
  ceres::Problem problem;
  auto* cost = new MeasurementCost(robot, options, measurements, selection, rungs, start);
  problem.AddResidualBlock(cost, nullptr, position.data(), orientation.coeffs().data(), densities.data());
  if (rigid) {
    problem.SetManifold(orientation.coeffs().data(), new ceres::EigenQuaternionManifold);
  } else {
    problem.SetParameterBlockConstant(orientation.coeffs().data());
  }

  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.logging_type = ceres::SILENT;
  solver.num_threads = 1;
  solver.max_num_iterations = kMaxIterations;
  solver.initial_trust_region_radius = 1e8;
  solver.function_tolerance = 1e-14;
  solver.gradient_tolerance = 0.0;
  solver.parameter_tolerance = 1e-10;
  solver.max_solver_time_in_seconds = std::min(left, 1e6);
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  adjusted.iterations = static_cast<int>(summary.iterations.size());
  if (!summary.IsSolutionUsable() || summary.termination_type == ceres::NO_CONVERGENCE) {
    const bool late = std::chrono::steady_clock::now() > deadline;
    adjusted.status = {late ? Code::kTimedOut : Code::kNotConverged,
                       late ? "the time allowed ran out while the pose was estimated"
                            : "no pose explains these lengths and tensions: check the robot's description and units"};
    return adjusted;
  }

  ceres::Problem::EvaluateOptions evaluate;
  evaluate.parameter_blocks = {position.data()};
  if (rigid) evaluate.parameter_blocks.push_back(orientation.coeffs().data());
  evaluate.parameter_blocks.push_back(densities.data());
  std::vector<double> residuals;
  ceres::CRSMatrix sparse;
  if (!problem.Evaluate(evaluate, nullptr, &residuals, nullptr, &sparse)) {
    adjusted.status = {Code::kInternalError, "the adjustment could not be evaluated at its own solution"};
    return adjusted;
  }
  adjusted.status.code = Code::kConverged;
  adjusted.unknowns.pose = {position, orientation.normalized()};
  for (const SaggingCable& cable : cost->cables()) {
    adjusted.unknowns.lengths.push_back(cable.length());
    adjusted.unknowns.forces.push_back({cable.horizontalForce(), cable.verticalForceA()});
  }
  adjusted.cables = cost->cables();
  adjusted.observations = observationsOf(robot, selection);
  for (std::size_t k = 0; k < residuals.size(); ++k) adjusted.observations[k].residual = residuals[k];
  adjusted.jacobian = dense(sparse);
  Eigen::MatrixXd& jacobian = adjusted.jacobian;
  if (rigid) jacobian.middleCols<3>(3) *= 0.5;  // the manifold's tangent is half the rotation vector
  const Eigen::Index freedoms = robot.freedoms();
  const LoadBalance balance = cost->loadBalance(adjusted.unknowns.pose, densities.data());
  Eigen::MatrixXd load(freedoms, jacobian.cols());
  load << balance.by_pose.topLeftCorner(freedoms, freedoms), balance.by_density.topRows(freedoms);
  analyse(jacobian, load, &adjusted);
  adjusted.stable = isStable(robot, cost->stiffness(balance));
  return adjusted;
}

}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/estimation/adjustment.h"

#include <ceres/ceres.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "cdpr_kinetostatics/robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxIterations = 100;

// B below A is taken this share of the length beside it.
constexpr double kBeside = 1e-9;

// A column of the Jacobian adds to its rank if more than this share of it is new.
constexpr double kRank = 1e-9;

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

// Redundancy of each observation, and the information on the pose once the cables' unknowns are eliminated.
// The Jacobian's columns: pose first, then the cables.
void analyse(const Eigen::MatrixXd& jacobian, Eigen::Index freedoms, Adjusted* adjusted) {
  const Eigen::VectorXd norms = jacobian.colwise().norm().cwiseMax(1e-300);
  const Eigen::MatrixXd scaled = jacobian * norms.cwiseInverse().asDiagonal();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> all(scaled);
  all.setThreshold(kRank);
  const Eigen::MatrixXd range = all.householderQ() * Eigen::MatrixXd::Identity(scaled.rows(), all.rank());
  adjusted->redundancy = -static_cast<int>(all.rank());
  std::vector<Observation> used;
  for (std::size_t k = 0; k < adjusted->observations.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    if (jacobian.row(row).squaredNorm() == 0.0) continue;  // a component of the load that is not known
    Observation observation = adjusted->observations[k];
    observation.redundancy = 1.0 - range.row(row).squaredNorm();
    adjusted->weighted_squares += observation.residual * observation.residual;
    ++adjusted->redundancy;
    used.push_back(observation);
  }
  adjusted->observations = used;

  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> cables(scaled.rightCols(jacobian.cols() - freedoms));
  cables.setThreshold(kRank);
  const Eigen::MatrixXd pose = cables.householderQ().transpose() * jacobian.leftCols(freedoms);
  const Eigen::MatrixXd left = pose.bottomRows(pose.rows() - cables.rank());
  adjusted->information = left.transpose() * left;
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
                const Selection& selection, const RobotForces& start, std::chrono::steady_clock::time_point deadline) {
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
    const double x = std::max(cableLine(robot.cables[i], start.pose).x, kBeside * start.lengths[i]);
    densities.push_back(start.forces[i].horizontal / x);
  }
  const bool rigid = robot.type == PlatformType::kRigidBody;
  ceres::Problem problem;
  auto* cost = new MeasurementCost(robot, options, measurements, selection, start);
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
  Eigen::MatrixXd jacobian = dense(sparse);
  if (rigid) jacobian.middleCols<3>(3) *= 0.5;  // the manifold's tangent is half the rotation vector
  analyse(jacobian, robot.freedoms(), &adjusted);
  return adjusted;
}

}  // namespace cdpr_kinetostatics

#include "estimation/measurement_cost.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "cable/iteration_schedule.h"
#include "geometry/spatial.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxClosureIterations = 30;

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

MeasurementCost::MeasurementCost(const RobotDescription& robot, const EstimatorOptions& options,
                                 const CableMeasurements& measurements, const Selection& selection,
                                 const std::vector<Model>& rungs, const RobotForces& start)
    : robot_(robot),
      options_(options),
      measurements_(measurements),
      selection_(selection),
      sensitivities_(robot.cables.size()) {
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    cables_.emplace_back(robot.cables[i].properties, rungs[i], options.tolerance);
    cables_.back().start(start.lengths[i], start.forces[i]);
  }
  AddParameterBlock(3);
  AddParameterBlock(4);
  AddParameterBlock(static_cast<int>(robot.cables.size()));
  const auto count = [](const std::vector<bool>& flags) { return std::count(flags.begin(), flags.end(), true); };
  SetNumResiduals(static_cast<int>(count(selection.lengths) + count(selection.tensions)) +
                  (selection.load.any() ? robot.freedoms() : 0));
}

// Closure at given H: Newton's method for (V, L), with the nodes of a bending cable. The first step takes the last
// linearisation, which is that of the last evaluation.
bool MeasurementCost::close(std::size_t i, const Pose& pose, double density) const {
  SaggingCable& cable = cables_[i];
  Sensitivity& s = sensitivities_[i];
  s.plane = cablePlane(robot_.cables[i], pose);
  const double x = distanceBeside(s.plane.x, cable.length());
  bool adapt = !linearised_;
  for (int k = 0; k < kMaxClosureIterations; ++k) {
    const bool fresh = k > 0 || !linearised_;
    if (fresh && !cable.linearise(adapt)) return false;
    const Eigen::Matrix<double, 2, 3>& jacobian = cable.end().jacobian;
    const Eigen::Matrix2d inverse = jacobian.rightCols<2>().inverse();
    Eigen::Vector3d change(density * x - cable.horizontalForce(), 0.0, 0.0);
    const Eigen::Vector2d defect = Eigen::Vector2d(x, s.plane.y) - cable.end().position;
    change.tail<2>() = inverse * (defect - jacobian.col(0) * change.x());
    if (!change.allFinite()) return false;
    const double size = std::max(
        {change.head<2>().norm() / cable.tensionA(), std::abs(change.z()) / cable.length(), cable.angleChange(change)});
    cable.step(change, std::min(1.0, cable.dampingFor(change)));
    if (size <= options_.tolerance && fresh && !adapt) {
      const Eigen::Matrix<double, 2, 6> end_by_pose = s.plane.toPlane() * motionOfPoint(s.plane.arm);
      s.by_pose.row(0) = density * end_by_pose.row(0);
      s.by_pose.bottomRows<2>() = inverse * (end_by_pose - jacobian.col(0) * s.by_pose.row(0));
      s.by_density << x, -inverse * jacobian.col(0) * x;
      return true;
    }
    adapt = choosesStepsNext(size, k);
  }
  return false;
}

LoadBalance MeasurementCost::loadBalance(const Pose& pose, const double* densities) const {
  LoadBalance balance;
  balance.total = loadWrench(robot_, pose, Wrench::Zero());
  balance.by_pose = weightStiffness(robot_, pose);
  balance.by_density.resize(6, static_cast<Eigen::Index>(cables_.size()));
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const Sensitivity& s = sensitivities_[i];
    const double q = robot_.cables[i].properties.weight;
    const double density = densities[i];
    const Eigen::Vector3d force =
        forceOnPlatform(s.plane, cables_[i].horizontalForce(), cables_[i].verticalForceA(), q * cables_[i].length());
    const Eigen::RowVector3d vertical(0.0, 1.0, -q);
    Eigen::Matrix<double, 3, 6> force_by_pose =
        Eigen::Vector3d(-density, -density, 0.0).asDiagonal() * motionOfPoint(s.plane.arm);
    force_by_pose.row(2) = vertical * s.by_pose;
    const Eigen::Vector3d force_by_density =
        -s.plane.x * s.plane.direction + vertical.dot(s.by_density) * Eigen::Vector3d::UnitZ();
    balance.total += wrenchAt(s.plane.arm, force);
    balance.by_pose += wrenchByMotion(s.plane.arm, force, force_by_pose);
    balance.by_density.col(static_cast<Eigen::Index>(i)) = wrenchAt(s.plane.arm, force_by_density);
  }
  return balance;
}

Eigen::Matrix<double, 6, 6> MeasurementCost::stiffness(const LoadBalance& balance) const {
  Eigen::Matrix<double, 6, 6> stiffness = balance.by_pose;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const Sensitivity& s = sensitivities_[i];
    stiffness -= balance.by_density.col(static_cast<Eigen::Index>(i)) * s.by_pose.row(2) / s.by_density.z();
  }
  return stiffness;
}

// Ceres asks for the Jacobian where it has just asked for the residuals: the cables are closed there already.
bool MeasurementCost::closeAll(const Pose& pose, double const* const* parameters) const {
  std::vector<double> at(parameters[0], parameters[0] + 3);
  at.insert(at.end(), parameters[1], parameters[1] + 4);
  at.insert(at.end(), parameters[2], parameters[2] + cables_.size());
  if (at == closed_at_) return true;
  closed_at_.clear();
  before_ = cables_;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    if (close(i, pose, parameters[2][i])) continue;
    cables_ = before_;
    return false;
  }
  linearised_ = true;
  closed_at_ = at;
  return true;
}

bool MeasurementCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Quaterniond orientation(parameters[1]);
  const Pose pose{Eigen::Vector3d(parameters[0]), orientation};
  const auto n = static_cast<Eigen::Index>(cables_.size());
  if (!closeAll(pose, parameters)) return false;

  RowMajor by_pose(num_residuals(), 6);
  RowMajor by_density = RowMajor::Zero(num_residuals(), n);
  Eigen::Index row = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!selection_.lengths[i]) continue;
    residuals[row] = (cables_[i].length() - *measurements_.lengths[i]) / options_.length_stddev;
    by_pose.row(row) = sensitivities_[i].by_pose.row(2) / options_.length_stddev;
    by_density(row, i) = sensitivities_[i].by_density.z() / options_.length_stddev;
    ++row;
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!selection_.tensions[i]) continue;
    const double tension = cables_[i].tensionA();
    residuals[row] = (tension - *measurements_.tensions[i]) / options_.tension_stddev;
    const Eigen::RowVector2d by_force = Eigen::RowVector2d(cables_[i].horizontalForce(), cables_[i].verticalForceA()) /
                                        (tension * options_.tension_stddev);
    by_pose.row(row) = by_force * sensitivities_[i].by_pose.topRows<2>();
    by_density(row, i) = by_force * sensitivities_[i].by_density.head<2>();
    ++row;
  }
  if (selection_.load.any()) {
    const Eigen::Index rows = robot_.freedoms();
    const Eigen::Array<double, 6, 1> weight = selection_.load.cast<double>() / options_.load_stddev.array();
    const LoadBalance balance = loadBalance(pose, parameters[2]);
    Eigen::Map<Eigen::ArrayXd>(residuals + row, rows) = (weight * balance.total.array()).head(rows);
    by_pose.bottomRows(rows) = (weight.matrix().asDiagonal() * balance.by_pose).topRows(rows);
    by_density.bottomRows(rows) = (weight.matrix().asDiagonal() * balance.by_density).topRows(rows);
  }
  if (jacobians == nullptr) return true;
  if (jacobians[0] != nullptr) Eigen::Map<RowMajor>(jacobians[0], num_residuals(), 3) = by_pose.leftCols<3>();
  if (jacobians[1] != nullptr) {
    Eigen::Map<RowMajor>(jacobians[1], num_residuals(), 4) = by_pose.rightCols<3>() * rotationByQuaternion(orientation);
  }
  if (jacobians[2] != nullptr) Eigen::Map<RowMajor>(jacobians[2], num_residuals(), n) = by_density;
  return true;
}

}  // namespace cdpr_kinetostatics

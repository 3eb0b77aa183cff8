#include "estimation/estimate_report.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "estimation/estimate_error.h"
#include "estimation/fault_search.h"
#include "robot/platform_error.h"
#include "robot/platform_statics.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {
namespace {

// Directions with a standard deviation beyond this share of the robot's span are not fixed by the data.
constexpr double kUnobservable = 1.0;

void fillCables(const MeasuredRobot& measured, Candidate* candidate, Estimate* estimate) {
  const Adjusted& adjusted = candidate->adjusted;
  const RobotDescription& robot = measured.robot;
  assemble(robot, estimate->load,
           describeCables(robot, adjusted.unknowns.pose, adjusted.cables, measured.options.profile_points),
           &estimate->solution);
  reportEffect(measured, candidate, &estimate->solution);
}

void fillCovariance(const RobotDescription& robot, const Eigen::MatrixXd& information, Estimate* estimate) {
  const auto n = static_cast<Eigen::Index>(robot.freedoms());
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(n);  // rotations as displacements of the platform's rim
  if (n == 6) scale.tail<3>().setConstant(1.0 / robot.lever());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * information * scale.asDiagonal());
  const double least = 1.0 / std::pow(kUnobservable * robot.span(), 2);
  estimate->covariance = kUnknownVariance * Eigen::Matrix<double, 6, 6>::Identity();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::VectorXd direction = scale.asDiagonal() * eigen.eigenvectors().col(k);
    const bool fixed = eigen.eigenvalues()(k) > least;
    if (!fixed) ++estimate->unobservable_directions;
    const double variance = fixed ? 1.0 / eigen.eigenvalues()(k) : kUnknownVariance / direction.squaredNorm();
    covariance += variance * direction * direction.transpose();
  }
  estimate->covariance.topLeftCorner(n, n) = covariance;
}

void fillLoadCovariance(const RobotDescription& robot, const Adjusted& adjusted, Estimate* estimate) {
  const auto n = static_cast<Eigen::Index>(robot.freedoms());
  estimate->load_unknown = adjusted.load_unknown;
  estimate->load_covariance.topLeftCorner(n, n) = adjusted.load_covariance;
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!adjusted.load_unknown(k)) continue;
    estimate->load_covariance.row(k).setZero();
    estimate->load_covariance.col(k).setZero();
    const double lever = k < 3 ? 1.0 : robot.lever();
    estimate->load_covariance(k, k) = std::pow(kUnknownLoad * robot.weight() * lever, 2);
  }
}

}  // namespace

Estimate report(const MeasuredRobot& measured, Candidate* candidate) {
  const RobotDescription& robot = measured.robot;
  Estimate estimate;
  const Adjusted& adjusted = candidate->adjusted;
  const RobotForces& at = adjusted.unknowns;
  estimate.solution.pose = at.pose;
  estimate.solution.report.status = adjusted.status;
  Wrench cables = Wrench::Zero();
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot.cables[i], at.pose);
    cables += wrenchAt(plane.arm, forceOnPlatform(plane, at.forces[i].horizontal, at.forces[i].vertical,
                                                  robot.cables[i].properties.weight * at.lengths[i]));
    const double tension = std::hypot(at.forces[i].horizontal, at.forces[i].vertical);
    estimate.length_residual.push_back(measured.available.lengths[i] ? *measured.measurements.lengths[i] - at.lengths[i]
                                                                     : 0.0);
    estimate.tension_residual.push_back(measured.available.tensions[i] ? *measured.measurements.tensions[i] - tension
                                                                       : 0.0);
  }
  estimate.load = -cables - loadWrench(robot, at.pose, Wrench::Zero());
  if (robot.type == PlatformType::kPointMass) estimate.load.tail<3>().setZero();
  fillLoadCovariance(robot, adjusted, &estimate);
  estimate.length_redundancy.assign(robot.cables.size(), 0.0);
  estimate.tension_redundancy.assign(robot.cables.size(), 0.0);
  for (const Observation& o : adjusted.observations) {
    if (o.kind == Observation::Kind::kLength) estimate.length_redundancy[o.index] = o.redundancy;
    if (o.kind == Observation::Kind::kTension) estimate.tension_redundancy[o.index] = o.redundancy;
  }
  const Selection left_out = leftOut(measured, *candidate);
  estimate.length_outlier = left_out.lengths;
  estimate.tension_outlier = left_out.tensions;
  estimate.load_outlier = left_out.load;
  estimate.weighted_squares = adjusted.weighted_squares;
  estimate.redundancy = adjusted.redundancy;
  fillCovariance(robot, adjusted.information, &estimate);
  fillCables(measured, candidate, &estimate);
  std::string& message = estimate.solution.report.status.message;
  if (measured.options.model == Model::kAuto) message = describeChoice(estimate.solution);
  if (estimate.unobservable_directions > 0) {
    std::ostringstream text;
    text << "the measurements leave " << estimate.unobservable_directions
         << " direction(s) of the pose unknown; they carry a variance of " << kUnknownVariance;
    message = message.empty() ? text.str() : text.str() + "; " + message;
  }
  return estimate;
}

}  // namespace cdpr_kinetostatics

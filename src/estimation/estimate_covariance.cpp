#include "estimation/estimate_covariance.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

// Directions with a standard deviation beyond this share of the robot's span are not fixed by the data.
constexpr double kUnobservable = 1.0;

// A rival weighs at least this share of the best answer. So the answer is within two standard deviations of it (three,
// if there are many), also where noise speaks against the truth.
constexpr double kLeastWeight = 1.0 / 3.0;
// More would say no more; the likelihood itself may not fit into a double.
constexpr double kMostWeight = 1e6;

using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct Certainty {
  Matrix6 pose = kUnknownVariance * Matrix6::Identity();
  int open_directions = 0;
  Matrix6 load = Matrix6::Zero();
  Eigen::Array<bool, 6, 1> load_unknown = Eigen::Array<bool, 6, 1>::Constant(false);
};

void fillPose(const RobotDescription& robot, const Eigen::MatrixXd& information, Certainty* certainty) {
  const auto n = static_cast<Eigen::Index>(robot.freedoms());
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(n);  // rotations as displacements of the platform's rim
  if (n == 6) scale.tail<3>().setConstant(1.0 / robot.lever());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * information * scale.asDiagonal());
  const double least = 1.0 / std::pow(kUnobservable * robot.span(), 2);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::VectorXd direction = scale.asDiagonal() * eigen.eigenvectors().col(k);
    const bool fixed = eigen.eigenvalues()(k) > least;
    if (!fixed) ++certainty->open_directions;
    const double variance = fixed ? 1.0 / eigen.eigenvalues()(k) : kUnknownVariance / direction.squaredNorm();
    covariance += variance * direction * direction.transpose();
  }
  certainty->pose.topLeftCorner(n, n) = covariance;
}

void fillLoad(const RobotDescription& robot, const Adjusted& adjusted, Certainty* certainty) {
  const auto n = static_cast<Eigen::Index>(robot.freedoms());
  certainty->load_unknown = adjusted.load_unknown;
  certainty->load.topLeftCorner(n, n) = adjusted.load_covariance;
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!adjusted.load_unknown(k)) continue;
    certainty->load.row(k).setZero();
    certainty->load.col(k).setZero();
    const double lever = k < 3 ? 1.0 : robot.lever();
    certainty->load(k, k) = std::pow(kUnknownLoad * robot.weight() * lever, 2);
  }
}

Certainty certaintyOf(const RobotDescription& robot, const Adjusted& adjusted) {
  Certainty certainty;
  fillPose(robot, adjusted.information, &certainty);
  fillLoad(robot, adjusted, &certainty);
  return certainty;
}

// (translation, rotation vector) from one pose to the other.
Wrench difference(const Pose& from, const Pose& to) {
  Wrench moved;
  Eigen::Quaterniond turn = to.orientation * from.orientation.conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const Eigen::AngleAxisd rotation(turn);
  moved << to.position - from.position, rotation.angle() * rotation.axis();
  return moved;
}

}  // namespace

Wrench balancingLoad(const RobotDescription& robot, const Adjusted& adjusted) {
  const Pose& pose = adjusted.unknowns.pose;
  Wrench cables = Wrench::Zero();
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const SaggingCable& cable = adjusted.cables[i];
    const CablePlane plane = cablePlane(robot.cables[i], pose);
    const double weight = cable.verticalForceA() - cable.verticalForceB();
    cables += wrenchAt(plane.arm, forceOnPlatform(plane, cable.horizontalForce(), cable.verticalForceA(), weight));
  }
  Wrench load = -cables - loadWrench(robot, pose, Wrench::Zero());
  if (robot.type == PlatformType::kPointMass) load.tail<3>().setZero();
  return load;
}

// The covariance of a mixture, about the best answer instead of the mean: the answer is the best one.
void fillCovariances(const RobotDescription& robot, const Candidate& best, const std::vector<Candidate>& rivals,
                     Estimate* estimate) {
  Certainty certainty = certaintyOf(robot, best.adjusted);
  double weights = 1.0;
  for (const Candidate& rival : rivals) {
    const double more = rival.adjusted.weighted_squares - best.adjusted.weighted_squares;
    const double weight = std::clamp(std::exp(-0.5 * more), kLeastWeight, kMostWeight);
    const Certainty other = certaintyOf(robot, rival.adjusted);
    const Wrench moved = difference(best.adjusted.unknowns.pose, rival.adjusted.unknowns.pose);
    const Wrench load = balancingLoad(robot, rival.adjusted) - balancingLoad(robot, best.adjusted);
    certainty.pose += weight * (other.pose + moved * moved.transpose());
    certainty.load += weight * (other.load + load * load.transpose());
    certainty.load_unknown = certainty.load_unknown || other.load_unknown;
    certainty.open_directions = std::max(certainty.open_directions, other.open_directions);
    weights += weight;
  }
  estimate->covariance = certainty.pose / weights;
  estimate->unobservable_directions = certainty.open_directions;
  estimate->load_covariance = certainty.load / weights;
  estimate->load_unknown = certainty.load_unknown;
}

}  // namespace cdpr_kinetostatics

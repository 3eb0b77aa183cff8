#include "robot/spring_platform.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kMaxIterations = 500;

// Strain of the softest springs under the load, and how much stiffer the next ones are.
constexpr double kSoftStrain = 0.01;
constexpr double kStiffening = 10.0;
constexpr double kSoftTolerance = 1e-3;

// Rounding of the energy, relative to the sum of its terms.
constexpr double kEnergyRounding = 1e-14;

// Largest step of the platform: a share of the robot's span, and an angle.
constexpr double kMaxShareOfSpan = 0.2;
constexpr double kMaxRotation = 0.5;  // [rad]

}  // namespace

double Spring::tension(double chord) const {
  const double t = shift + stiffness * (chord - length);
  return two_sided ? t : std::max(t, 0.0);
}

SpringPlatform::Local SpringPlatform::at(const Pose& pose, const std::vector<Spring>& springs) const {
  Local local;
  if (external_ != nullptr) {
    local.wrench = loadWrench(robot_, pose, *external_);
    local.stiffness = weightStiffness(robot_, pose);
    local.energy = robot_.weight() * pose.transform(robot_.com).z() - external_->head<3>().dot(pose.position);
  }
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const CableDescription& cable = robot_.cables[i];
    const Eigen::Vector3d arm = pose.orientation * cable.attachment;
    const Eigen::Vector3d along = anchorToAttachment(cable, pose);
    const double chord = std::max(along.norm(), 1e-12 * springs[i].length);
    const Eigen::Vector3d unit = along / chord;
    const double tension = springs[i].tension(chord);
    Eigen::Vector3d force = -tension * unit;
    Eigen::Matrix3d by_b = -tension / chord * (Eigen::Matrix3d::Identity() - unit * unit.transpose());
    if (tension > 0.0 || springs[i].two_sided) by_b -= springs[i].stiffness * unit * unit.transpose();
    local.energy += 0.5 * tension * tension / springs[i].stiffness;
    if (external_ != nullptr) {
      const double half_weight = 0.5 * cable.properties.weight * springs[i].length;
      force.z() -= half_weight;
      local.energy += half_weight * along.z();
    }
    local.wrench += wrenchAt(arm, force);
    local.stiffness += wrenchByMotion(arm, force, by_b * motionOfPoint(arm));
  }
  return local;
}

Status SpringPlatform::descend(const std::vector<Spring>& springs, double tolerance, Clock::time_point deadline,
                               Pose* pose, int* iterations) const {
  if (external_ != nullptr) {
    double stiffest = 0.0;
    for (const Spring& spring : springs) stiffest = std::max(stiffest, spring.stiffness * spring.length);
    const double load = std::max(robot_.weight(), external_->head<3>().norm());
    for (double soft = load / kSoftStrain; soft < stiffest; soft *= kStiffening) {
      std::vector<Spring> softened = springs;
      for (Spring& spring : softened) spring.stiffness = std::min(spring.stiffness, soft / spring.length);
      const Status status = newton(softened, std::max(tolerance, kSoftTolerance), deadline, pose, iterations);
      if (status.code == Code::kTimedOut) return status;
    }
  }
  return newton(springs, tolerance, deadline, pose, iterations);
}

Status SpringPlatform::newton(const std::vector<Spring>& springs, double tolerance, Clock::time_point deadline,
                              Pose* pose, int* iterations) const {
  const int n = robot_.freedoms();
  const double radius = n == 6 ? robot_.lever() : 1.0;
  Wrench scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / radius);
  const Eigen::Vector3d torque = external_ != nullptr ? Eigen::Vector3d(external_->tail<3>()) : Eigen::Vector3d::Zero();
  Local here = at(*pose, springs);
  double damping = 0.0;
  for (int i = 0; i < kMaxIterations; ++i) {
    if (Clock::now() > deadline) return {Code::kTimedOut, "the time allowed ran out while looking for the pose"};
    ++*iterations;
    const Matrix6 hessian =
        -0.5 * scale.asDiagonal() * (here.stiffness + here.stiffness.transpose()).eval() * scale.asDiagonal();
    // All springs may be slack: the platform then falls, as far as a step may take it.
    const double size =
        std::max(hessian.topLeftCorner(n, n).diagonal().cwiseAbs().maxCoeff(), robot_.weight() / robot_.span());
    const Eigen::LLT<Eigen::MatrixXd> cholesky(hessian.topLeftCorner(n, n) +
                                               damping * size * Eigen::MatrixXd::Identity(n, n));
    if (cholesky.info() != Eigen::Success) {
      damping = std::max(10.0 * damping, 1e-9);
      continue;
    }
    Wrench step = Wrench::Zero();
    step.head(n) = cholesky.solve((scale.asDiagonal() * here.wrench).head(n));
    step = scale.asDiagonal() * step;
    const double translation = step.head<3>().norm() / robot_.span();
    const double rotation = step.tail<3>().norm();
    step *= std::min({1.0, kMaxShareOfSpan / translation, kMaxRotation / rotation});
    const Pose moved = displaced(*pose, step.head<3>(), step.tail<3>());
    const Local there = at(moved, springs);
    const double gain = here.energy - there.energy + torque.dot(step.tail<3>());
    const bool tiny = translation < 0.01 * tolerance && rotation < 0.01 * tolerance;
    // Below the energy's rounding the wrench decides, and where it no longer falls the pose is found.
    const double rounding = kEnergyRounding * (std::abs(here.energy) + robot_.weight() * robot_.span());
    const bool at_rounding = tiny || here.wrench.dot(step) < rounding;
    const bool calmer =
        (scale.asDiagonal() * there.wrench).head(n).norm() < (scale.asDiagonal() * here.wrench).head(n).norm();
    if (at_rounding ? calmer : gain >= 1e-4 * here.wrench.dot(step)) {
      *pose = moved;
      here = there;
      damping *= damping < 1e-9 ? 0.0 : 0.1;
      if (tiny && damping == 0.0) return {Code::kConverged, ""};
    } else if (at_rounding) {
      return {Code::kConverged, ""};
    } else {
      damping = std::max(10.0 * damping, 1e-9);
    }
  }
  return {Code::kNotConverged, "no stable pose was found with straight cables of these lengths"};
}

}  // namespace cdpr_kinetostatics

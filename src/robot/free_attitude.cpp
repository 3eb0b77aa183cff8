#include "robot/free_attitude.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/spatial.h"

namespace cdpr_kinetostatics {
namespace {

// Largest turn of a free attitude in one iteration.
constexpr double kMaxTurn = 0.2;  // [rad]

// The pitch stays below a right angle by this much: at it, yaw and roll are one.
constexpr double kSteepestPitch = 1.5607963267948966;  // pi/2 - 0.01 [rad]

}  // namespace

FreeAttitude::FreeAttitude(const RobotDescription& robot, const InverseRequest& request) {
  if (!request.free_orientation || robot.type != PlatformType::kRigidBody) return;
  freedoms_ = request.hold_yaw ? 2 : 3;
  yaw_ = rollPitchYaw(request.pose.orientation).z();
}

FreeAttitude::Axes FreeAttitude::axes(const Pose& pose) const {
  if (!holdsHeading()) return Eigen::Matrix3d::Identity().leftCols(freedoms_);
  const double pitch = rollPitchYaw(pose.orientation).y();
  const Eigen::AngleAxisd heading(yaw_, Eigen::Vector3d::UnitZ());
  Axes axes(3, 2);
  axes.col(0) = heading * Eigen::Vector3d::UnitY();
  axes.col(1) = heading * Eigen::Vector3d(std::cos(pitch), 0.0, -std::sin(pitch));
  return axes;
}

Pose FreeAttitude::turned(const Pose& pose, const Turn& turn) const {
  if (freedoms_ == 0) return pose;
  if (!holdsHeading()) return displaced(pose, Eigen::Vector3d::Zero(), turn);
  const Eigen::Vector3d angles = rollPitchYaw(pose.orientation);
  Pose moved = pose;
  moved.orientation = fromRollPitchYaw({angles.x() + turn(1), angles.y() + turn(0), yaw_});
  return moved;
}

Pose FreeAttitude::allowed(const Pose& pose) const {
  if (!holdsHeading()) return pose;
  const Eigen::Vector3d angles = rollPitchYaw(pose.orientation);
  Pose put_right = pose;
  put_right.orientation = fromRollPitchYaw({angles.x(), std::clamp(angles.y(), -kSteepestPitch, kSteepestPitch), yaw_});
  return put_right;
}

FreeAttitude::Turn FreeAttitude::least(const Pose& pose) const {
  Turn least = Turn::Constant(freedoms_, -kMaxTurn);
  if (holdsHeading()) least(0) = std::max(least(0), -kSteepestPitch - rollPitchYaw(pose.orientation).y());
  return least;
}

FreeAttitude::Turn FreeAttitude::most(const Pose& pose) const {
  Turn most = Turn::Constant(freedoms_, kMaxTurn);
  if (holdsHeading()) most(0) = std::min(most(0), kSteepestPitch - rollPitchYaw(pose.orientation).y());
  return most;
}

}  // namespace cdpr_kinetostatics

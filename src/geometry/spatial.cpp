#include "geometry/spatial.h"

#include <cmath>

namespace cdpr_kinetostatics {

Eigen::Matrix3d cross(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return matrix;
}

Wrench wrenchAt(const Eigen::Vector3d& arm, const Eigen::Vector3d& force) {
  Wrench wrench;
  wrench << force, arm.cross(force);
  return wrench;
}

Eigen::Matrix<double, 3, 6> motionOfPoint(const Eigen::Vector3d& arm) {
  Eigen::Matrix<double, 3, 6> motion;
  motion << Eigen::Matrix3d::Identity(), -cross(arm);
  return motion;
}

Eigen::Matrix<double, 6, 6> wrenchByMotion(const Eigen::Vector3d& arm, const Eigen::Vector3d& force,
                                           const Eigen::Matrix<double, 3, 6>& force_by_motion) {
  const Eigen::Matrix3d arm_cross = cross(arm);
  Eigen::Matrix<double, 6, 6> by_motion;
  by_motion.topRows<3>() = force_by_motion;
  by_motion.bottomRows<3>() = arm_cross * force_by_motion;
  by_motion.bottomRightCorner<3, 3>() += cross(force) * arm_cross;
  return by_motion;
}

Pose displaced(const Pose& pose, const Eigen::Vector3d& translation, const Eigen::Vector3d& rotation) {
  Pose moved = pose;
  moved.position += translation;
  const double angle = rotation.norm();
  if (angle > 0.0) {
    moved.orientation = (Eigen::AngleAxisd(angle, rotation / angle) * pose.orientation).normalized();
  }
  return moved;
}

Eigen::Quaterniond fromRollPitchYaw(const Eigen::Vector3d& angles) {
  return Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX());
}

Eigen::Vector3d rollPitchYaw(const Eigen::Quaterniond& attitude) {
  const Eigen::Matrix3d r = attitude.toRotationMatrix();
  return {std::atan2(r(2, 1), r(2, 2)), std::atan2(-r(2, 0), std::hypot(r(2, 1), r(2, 2))),
          std::atan2(r(1, 0), r(0, 0))};
}

Eigen::Matrix<double, 3, 4> rotationJacobian(const Eigen::Quaterniond& q, const Eigen::Vector3d& v) {
  const Eigen::Vector3d u = q.vec();
  Eigen::Matrix<double, 3, 4> jacobian;
  jacobian.leftCols<3>() =
      2.0 * (-q.w() * cross(v) + u.dot(v) * Eigen::Matrix3d::Identity() + u * v.transpose() - 2.0 * v * u.transpose());
  jacobian.col(3) = 2.0 * u.cross(v);
  return jacobian;
}

Eigen::Matrix<double, 3, 4> rotationByQuaternion(const Eigen::Quaterniond& q) {
  Eigen::Matrix<double, 3, 4> matrix;
  matrix << q.w(), -q.z(), q.y(), -q.x(), q.z(), q.w(), -q.x(), -q.y(), -q.y(), q.x(), q.w(), -q.z();
  return 2.0 * matrix;
}

}  // namespace cdpr_kinetostatics

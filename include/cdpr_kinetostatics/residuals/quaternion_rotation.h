// Derivative of a rotated vector with respect to a quaternion's coefficients, for analytic Jacobians.
#pragma once

#include <Eigen/Geometry>

namespace cdpr_kinetostatics {

// d(q v)/d(x, y, z, w) of v + 2 w u x v + 2 u x (u x v), u = (x, y, z): the rotation where q is a unit.
inline Eigen::Matrix<double, 3, 4> rotationJacobian(const Eigen::Quaterniond& q, const Eigen::Vector3d& v) {
  const Eigen::Vector3d u = q.vec();
  Eigen::Matrix3d v_cross;
  v_cross << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  Eigen::Matrix<double, 3, 4> jacobian;
  jacobian.leftCols<3>() =
      2.0 * (-q.w() * v_cross + u.dot(v) * Eigen::Matrix3d::Identity() + u * v.transpose() - 2.0 * v * u.transpose());
  jacobian.col(3) = 2.0 * u.cross(v);
  return jacobian;
}

}  // namespace cdpr_kinetostatics

// Vectors, wrenches and small motions of a rigid platform: what every solver of the robot computes with.
//
// World axes throughout; a wrench and a motion are force or translation, then moment or rotation vector, about the
// platform's origin (docs/conventions.md).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cdpr_kinetostatics/geometry/pose.h"

namespace cdpr_kinetostatics {

// The matrix of v -> a x v.
Eigen::Matrix3d cross(const Eigen::Vector3d& a);

// The wrench of a force [N] that acts at arm [m] from the platform's origin.
Wrench wrenchAt(const Eigen::Vector3d& arm, const Eigen::Vector3d& force);

// How the point at arm moves with the platform: d(point)/d(translation, rotation vector).
Eigen::Matrix<double, 3, 6> motionOfPoint(const Eigen::Vector3d& arm);

// Derivative of wrenchAt() with respect to the platform's motion, for a force that changes by force_by_motion and whose
// point of attack turns with the platform.
Eigen::Matrix<double, 6, 6> wrenchByMotion(const Eigen::Vector3d& arm, const Eigen::Vector3d& force,
                                           const Eigen::Matrix<double, 3, 6>& force_by_motion);

// The pose moved by a translation and turned by a rotation vector.
Pose displaced(const Pose& pose, const Eigen::Vector3d& translation, const Eigen::Vector3d& rotation);

// (roll, pitch, yaw) [rad] of R = Rz(yaw) Ry(pitch) Rx(roll): turns about fixed axes, roll first, as in URDF.
Eigen::Quaterniond fromRollPitchYaw(const Eigen::Vector3d& angles);
Eigen::Vector3d rollPitchYaw(const Eigen::Quaterniond& attitude);

// d(q v)/d(x, y, z, w) of v + 2 w u x v + 2 u x (u x v) with u = (x, y, z): the rotation where q is a unit quaternion.
Eigen::Matrix<double, 3, 4> rotationJacobian(const Eigen::Quaterniond& q, const Eigen::Vector3d& v);

// d(rotation vector)/d(x, y, z, w) for small changes of a unit quaternion: 2 (dq conj(q)).vec.
Eigen::Matrix<double, 3, 4> rotationByQuaternion(const Eigen::Quaterniond& q);

}  // namespace cdpr_kinetostatics

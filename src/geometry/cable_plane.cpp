#include "geometry/cable_plane.h"

#include <algorithm>
#include <cmath>

#include "geometry/spatial.h"

namespace cdpr_kinetostatics {
namespace {

// Nearer to the vertical through A than this share of the distance, B counts as above or below A: its direction would
// be that of rounding.
constexpr double kVertical = 1e-12;

// Nearer than this share H/x has lost half of its digits, and the stiffness, which tends to it, is the better number.
constexpr double kNearlyVertical = 1e-9;

// B above or below A is taken this share of the length beside it: far above rounding, far below any tolerance.
constexpr double kBeside = 1e-9;

}  // namespace

Eigen::Matrix<double, 2, 3> CablePlane::toPlane() const {
  Eigen::Matrix<double, 2, 3> to_plane;
  to_plane << direction.transpose(), Eigen::RowVector3d::UnitZ();
  return to_plane;
}

Eigen::Matrix<double, 3, 2> CablePlane::forceByForces() const {
  Eigen::Matrix<double, 3, 2> force;
  force << -direction, Eigen::Vector3d::UnitZ();
  return force;
}

Eigen::Vector3d anchorToAttachment(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment, const Pose& pose) {
  return pose.position + pose.orientation * attachment - anchor;
}

CablePlane cablePlane(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment, const Pose& pose) {
  CablePlane plane;
  plane.arm = pose.orientation * attachment;
  const Eigen::Vector3d to_b = pose.position + plane.arm - anchor;
  plane.y = to_b.z();
  plane.x = std::hypot(to_b.x(), to_b.y());
  plane.direction = plane.x > kVertical * std::abs(plane.y)
                        ? Eigen::Vector3d(to_b.x() / plane.x, to_b.y() / plane.x, 0.0)
                        : Eigen::Vector3d::UnitX();
  return plane;
}

double distanceBeside(double x, double length) { return std::max(x, kBeside * length); }

Eigen::Vector3d forceOnPlatform(const CablePlane& plane, double horizontal_force, double vertical_force_a,
                                double cable_weight) {
  return forceAtB(plane, horizontal_force, vertical_force_a - cable_weight);
}

Eigen::Vector3d forceAtB(const CablePlane& plane, double horizontal_force, double vertical_force_b) {
  return -horizontal_force * plane.direction + vertical_force_b * Eigen::Vector3d::UnitZ();
}

Eigen::Matrix<double, 6, 2> wrenchByForces(const CablePlane& plane) {
  Eigen::Matrix<double, 6, 2> wrench;
  wrench << wrenchAt(plane.arm, -plane.direction), wrenchAt(plane.arm, Eigen::Vector3d::UnitZ());
  return wrench;
}

double forceDensity(const CablePlane& plane, double horizontal_force, const Eigen::Matrix2d& stiffness) {
  return plane.x > kNearlyVertical * std::abs(plane.y) ? horizontal_force / plane.x : stiffness(0, 0);
}

void addCableStiffness(const CablePlane& plane, const Eigen::Matrix2d& stiffness, const Eigen::Vector3d& force,
                       double density, Eigen::Matrix<double, 6, 6>* total) {
  const Eigen::Vector3d side = plane.side();
  const Eigen::Matrix3d by_translation =
      plane.forceByForces() * stiffness * plane.toPlane() - density * side * side.transpose();
  const Eigen::Matrix3d arm = cross(plane.arm);
  const Eigen::Matrix3d by_rotation = -by_translation * arm;
  total->topLeftCorner<3, 3>() += by_translation;
  total->topRightCorner<3, 3>() += by_rotation;
  total->bottomLeftCorner<3, 3>() += arm * by_translation;
  total->bottomRightCorner<3, 3>() += arm * by_rotation + cross(force) * arm;
}

}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/robot/platform_statics.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {
namespace {

// Nearer to the vertical through A than this share of the distance, B counts as above or below A.
constexpr double kVertical = 1e-12;

// Nearer than this share H/x loses its digits.
constexpr double kNearlyVertical = 1e-9;

// B above or below A is taken this share of the length beside it.
constexpr double kBeside = 1e-9;

}  // namespace

CableLine cableLine(const CableDescription& cable, const Pose& pose) {
  CableLine line;
  line.arm = pose.orientation * cable.attachment;
  const Eigen::Vector3d to_b = pose.position + line.arm - cable.anchor;
  line.w = to_b.z();
  line.x = std::hypot(to_b.x(), to_b.y());
  line.direction = line.x > kVertical * std::abs(line.w) ? Eigen::Vector3d(to_b.x() / line.x, to_b.y() / line.x, 0.0)
                                                         : Eigen::Vector3d::UnitX();
  return line;
}

double distanceBeside(const CableLine& line, double length) { return std::max(line.x, kBeside * length); }

Eigen::Vector3d forceOnPlatform(const CableLine& line, double horizontal_force, double vertical_force_a,
                                double cable_weight) {
  return -horizontal_force * line.direction + (vertical_force_a - cable_weight) * Eigen::Vector3d::UnitZ();
}

double forceDensity(const CableLine& line, double horizontal_force, const Eigen::Matrix2d& stiffness) {
  return line.x > kNearlyVertical * std::abs(line.w) ? horizontal_force / line.x : stiffness(0, 0);
}

Wrench wrenchAt(const Eigen::Vector3d& arm, const Eigen::Vector3d& force) {
  Wrench wrench;
  wrench << force, arm.cross(force);
  return wrench;
}

Wrench loadWrench(const RobotDescription& robot, const Pose& pose, const Wrench& external) {
  const Eigen::Vector3d weight(0.0, 0.0, -robot.weight());
  return wrenchAt(pose.orientation * robot.com, weight) + external;
}

Eigen::Matrix<double, 6, 6> weightStiffness(const RobotDescription& robot, const Pose& pose) {
  const Eigen::Vector3d weight(0.0, 0.0, -robot.weight());
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
  stiffness.bottomRightCorner<3, 3>() = cross(weight) * cross(pose.orientation * robot.com);
  return stiffness;
}

Eigen::Matrix3d cross(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return matrix;
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

}  // namespace cdpr_kinetostatics

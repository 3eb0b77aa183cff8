#include "linear_robot.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {
Eigen::Matrix<double, 6, 2> wrenchByForces(const CableLine& line) {
  Eigen::Matrix<double, 6, 2> wrench;
  wrench << wrenchAt(line.arm, -line.direction), wrenchAt(line.arm, Eigen::Vector3d::UnitZ());
  return wrench;
}

LinearRobot::LinearRobot(const RobotDescription& robot, const Pose& pose)
    : radius_(std::max(robot.platformRadius(), 1e-6 * robot.span())),
      rigid_(robot.type == PlatformType::kRigidBody),
      stiffness_(weightStiffness(robot, pose)) {
  if (rigid_) scale_.tail<3>().setConstant(1.0 / radius_);
}

void LinearRobot::add(const CableLine& line, const Eigen::Matrix2d& stiffness, double h, const Eigen::Vector3d& force) {
  Eigen::Matrix<double, 2, 6> end_by_pose;
  end_by_pose.leftCols<3>() << line.direction.transpose(), Eigen::RowVector3d::UnitZ();
  end_by_pose.rightCols<3>() = end_by_pose.leftCols<3>() * -cross(line.arm);
  const Eigen::Vector3d side(-line.direction.y(), line.direction.x(), 0.0);
  const Wrench side_wrench = wrenchAt(line.arm, side);
  Eigen::Matrix<double, 6, 6> added = wrenchByForces(line) * stiffness * end_by_pose -
                                      forceDensity(line, h, stiffness) * side_wrench * side_wrench.transpose();
  added.bottomRightCorner<3, 3>() += cross(force) * cross(line.arm);
  if (rigid_) {
    stiffness_ += added;
  } else {
    stiffness_.topLeftCorner<3, 3>() += added.topLeftCorner<3, 3>();
  }
}

bool LinearRobot::factorise() {
  // A point mass's rotations are as stiff as its translations: they take no part, and hide no singularity.
  if (!rigid_) stiffness_.diagonal().tail<3>().setConstant(stiffness_.topLeftCorner<3, 3>().cwiseAbs().maxCoeff());
  lu_.compute(scale_.asDiagonal() * stiffness_ * scale_.asDiagonal());
  return stiffness_.allFinite() && lu_.rcond() > 1e-15;
}

}  // namespace cdpr_kinetostatics

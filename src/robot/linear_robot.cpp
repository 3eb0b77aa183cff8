#include "robot/linear_robot.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {

LinearRobot::LinearRobot(const RobotDescription& robot, const Pose& pose)
    : radius_(robot.lever()), rigid_(robot.type == PlatformType::kRigidBody), stiffness_(weightStiffness(robot, pose)) {
  if (rigid_) scale_.tail<3>().setConstant(1.0 / radius_);
}

void LinearRobot::add(const CablePlane& plane, const Eigen::Matrix2d& stiffness, double h,
                      const Eigen::Vector3d& force) {
  Eigen::Matrix<double, 6, 6> added = Eigen::Matrix<double, 6, 6>::Zero();
  addCableStiffness(plane, stiffness, force, forceDensity(plane, h, stiffness), &added);
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

// Position and orientation of the platform frame in the world.
#pragma once

#include <Eigen/Geometry>

namespace cdpr_kinetostatics {

struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               // [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  // unit, platform to world

  Eigen::Vector3d transform(const Eigen::Vector3d& in_platform) const { return position + orientation * in_platform; }
};

// Force then torque about the platform origin, in world axes [N, N m].
using Wrench = Eigen::Matrix<double, 6, 1>;

}  // namespace cdpr_kinetostatics

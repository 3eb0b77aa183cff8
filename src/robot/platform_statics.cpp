#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {

CablePlane cablePlane(const CableDescription& cable, const Pose& pose) {
  return cablePlane(cable.anchor, cable.attachment, pose);
}

Eigen::Vector3d anchorToAttachment(const CableDescription& cable, const Pose& pose) {
  return anchorToAttachment(cable.anchor, cable.attachment, pose);
}

Wrench loadWrench(const RobotDescription& robot, const Pose& pose, const Wrench& external) {
  const Eigen::Vector3d weight(0.0, 0.0, -robot.weight());
  return wrenchAt(pose.orientation * robot.com, weight) + external;
}

Eigen::Matrix<double, 6, 6> weightStiffness(const RobotDescription& robot, const Pose& pose) {
  const Eigen::Vector3d weight(0.0, 0.0, -robot.weight());
  return wrenchByMotion(pose.orientation * robot.com, weight, Eigen::Matrix<double, 3, 6>::Zero());
}

}  // namespace cdpr_kinetostatics

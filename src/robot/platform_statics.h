// A robot's cables and weight at a pose.
#pragma once

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "geometry/cable_plane.h"
#include "geometry/spatial.h"

namespace cdpr_kinetostatics {

CablePlane cablePlane(const CableDescription& cable, const Pose& pose);

// B - A [m], world axes.
Eigen::Vector3d anchorToAttachment(const CableDescription& cable, const Pose& pose);

// The platform's weight and the external wrench.
Wrench loadWrench(const RobotDescription& robot, const Pose& pose, const Wrench& external);

// d(wrench of the weight)/d(translation, rotation vector).
Eigen::Matrix<double, 6, 6> weightStiffness(const RobotDescription& robot, const Pose& pose);

}  // namespace cdpr_kinetostatics

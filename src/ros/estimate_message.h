// Turns an estimate into the messages that are published.
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/WrenchStamped.h>

#include "cdpr_kinetostatics/KinetostaticState.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "ros/measurement_input.h"

namespace cdpr_kinetostatics {

// All numbers of the message are finite: an estimate with a number that is not becomes an INTERNAL_ERROR. Unless the
// code is CONVERGED, the pose is the robot's home with unknown covariance, and there are no cables.
KinetostaticState toMsg(const Estimate& estimate, const Measurement& measurement, const RobotDescription& robot,
                        const std::string& base_frame);

geometry_msgs::PoseWithCovarianceStamped poseOf(const KinetostaticState& state);
geometry_msgs::WrenchStamped loadOf(const KinetostaticState& state);
geometry_msgs::TransformStamped transformOf(const KinetostaticState& state, const std::string& platform_frame);

}  // namespace cdpr_kinetostatics

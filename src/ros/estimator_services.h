// ~set_pose and ~reset.
#pragma once

#include <std_srvs/Trigger.h>

#include "cdpr_kinetostatics/SetPose.h"
#include "ros/estimator_loop.h"

namespace cdpr_kinetostatics {

SetPose::Response serveSetPose(EstimatorLoop& loop, const NodeParameters& parameters, const SetPose::Request& request);
std_srvs::Trigger::Response serveReset(EstimatorLoop& loop);

}  // namespace cdpr_kinetostatics

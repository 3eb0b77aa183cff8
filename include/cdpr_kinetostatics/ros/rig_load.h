// The external load on the simulated platform at a time.
#pragma once

#include "cdpr_kinetostatics/robot/pose.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/ros/rig_parameters.h"

namespace cdpr_kinetostatics {

// World axes, about the platform's origin [N, N m], `time` seconds after the rig's start: the last of ~loads, and what
// ~load_noise draws for that second. A function of its arguments alone.
Wrench rigLoad(const RigParameters& parameters, double time);

}  // namespace cdpr_kinetostatics

// The external load on the simulated platform at a time.
#pragma once

#include "cdpr_kinetostatics/geometry/pose.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "rig/rig_parameters.h"

namespace cdpr_kinetostatics {

// World axes, about the platform's origin [N, N m], `time` seconds after the rig's start. Both are functions of their
// arguments alone.

// The last of ~loads: the rig holds its path under it.
Wrench rigLoad(const RigParameters& parameters, double time);

// What ~load_noise draws for that second: nobody knows of it, so the platform gives way.
Wrench unknownRigLoad(const RigParameters& parameters, double time);

}  // namespace cdpr_kinetostatics

// The external load on the simulated platform at a time.
#pragma once

#include "cdpr_kinetostatics/geometry/pose.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "rig/parameters.h"

namespace cdpr_kinetostatics {

// World axes, about the platform's origin [N, N m], `time` seconds after the rig's start. Both are functions of their
// arguments alone.

// The load of ~loads that has come last. The rig knows it, and holds its path under it.
Wrench rigLoad(const RigParameters& parameters, double time);

// The load that ~load_noise draws for that second. The rig does not know it when it chooses lengths, so the platform
// gives way under it.
Wrench unknownRigLoad(const RigParameters& parameters, double time);

}  // namespace cdpr_kinetostatics

// Where an adjustment starts without a last estimate.
#pragma once

#include "estimation/measured_robot.h"

namespace cdpr_kinetostatics {

// The stable pose on springs near the seed, with the measured tensions.
RobotForces coldStart(const MeasuredRobot& measured, const Pose& seed, int* iterations);

}  // namespace cdpr_kinetostatics

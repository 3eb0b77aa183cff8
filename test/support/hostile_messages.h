// What an estimator may be sent by a robot out of order: wrong units, swapped cables, nonsense, another robot's data.
#pragma once

#include <vector>

#include "simulated_measurements.h"

namespace cdpr_kinetostatics {

// A message that is wrong in one of many ways, chosen by the dice; made from a good one.
CableMeasurements hostileMessage(const CableMeasurements& good, Dice* dice);

// One to five hostile messages or set_pose by any pose, in any order.
void mistreat(const SimulatedRobot& robot, const CableMeasurements& good, Dice* dice, PoseEstimator* estimator);

}  // namespace cdpr_kinetostatics

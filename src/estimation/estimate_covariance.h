// How certain the pose and the load of an adjustment are.
#pragma once

#include <vector>

#include "estimation/measured_robot.h"

namespace cdpr_kinetostatics {

// External load that balances the cables and the platform's weight.
Wrench balancingLoad(const RobotDescription& robot, const Adjusted& adjusted);

// Covariances of pose and load, and what of them is unknown. They cover the answers of rivals, too, each by its
// likelihood.
void fillCovariances(const RobotDescription& robot, const Candidate& best, const std::vector<Candidate>& rivals,
                     Estimate* estimate);

}  // namespace cdpr_kinetostatics

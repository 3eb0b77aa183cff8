// What to say where the limits of the tensions cannot all be met.
#pragma once

#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/tension_distribution.h"
#include "robot/inverse_cable.h"

namespace cdpr_kinetostatics {

// INFEASIBLE, with the names of the cables and limits that contradict each other; the least tension that can hold a
// cable is a limit too.
Status contradiction(const RobotDescription& robot, const std::vector<InverseCable>& cables,
                     const TensionDistribution& distribution);

}  // namespace cdpr_kinetostatics

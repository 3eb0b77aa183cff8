// A family of suspended robots, of any even number of cables from six on.
#pragma once

#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// A platform that hangs from a ring of 4 m radius by 2 * corners cables like the first one of `like`: two leave each
// corner of a regular polygon, to the two nearest corners of a polygon of 1 m radius, turned by half a corner. Its
// weight is `load` [N]. At home it is level, under the ring's centre, and cables of 4.5 m are straight.
RobotDescription suspendedPlatform(const RobotDescription& like, int corners, double load);

}  // namespace cdpr_kinetostatics

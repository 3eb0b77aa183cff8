// What the paper's section 4 leaves to future work: robots of six and more of its cables, a length swept from 4 to 5 m.
#pragma once

#include <ostream>

#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// A platform that hangs from a ring of 4 m radius by 2 * corners cables like the first one of `like`: two leave each
// corner of a regular polygon, to the two nearest corners of a polygon of 1 m radius, turned by half a corner. Its
// weight is `load` [N]. At home it is level, under the ring's centre, and cables of 4.5 m are straight.
RobotDescription suspendedPlatform(const RobotDescription& like, int corners, double load);

// Sweeps six and eight cables under 0.5 and 10 kN with each model: the first length alone, all others staying at
// 4.5 m; and all lengths together, as straight cables would move the platform level along x. Writes one line of CSV
// per point and prints a summary.
void sweepPlatforms(const RobotDescription& like, bool quick, std::ostream* csv);

}  // namespace cdpr_kinetostatics

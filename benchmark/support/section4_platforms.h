// What the paper's section 4 leaves to future work: robots of six and more of its cables, a length swept from 4 to 5 m.
#pragma once

#include <ostream>

#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// Sweeps six and eight cables under 0.5 and 10 kN with each model: the first length alone, all others staying at
// 4.5 m; and all lengths together, as straight cables would move the platform level along x. Writes one line of CSV
// per point and prints a summary.
void sweepPlatforms(const RobotDescription& like, bool quick, std::ostream* csv);

}  // namespace cdpr_kinetostatics

// Section 4 of the paper: a point mass on two cables whose first one grows from 4 to 5 m, the second one being 7 m.
#pragma once

#include <ostream>

#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// robot: the paper's. Solves each point of the sweep under 0.5 and 10 kN with each model as one coupled problem, and,
// with the bending models, every tenth point also by sweeping forces. Writes one line of CSV per point, prints a
// summary. Throws std::runtime_error if a point is not solved.
void sweepTwoCables(const RobotDescription& robot, bool quick, std::ostream* csv);

}  // namespace cdpr_kinetostatics

// A start for cables so stiff in bending that they push: where such bars do not fit together, they buckle at the
// strain of a hair, which no search on the real ones steps across. Bars that give way along their axis do not buckle:
// their axial stiffness is raised to the real one, along the equilibria between.
#pragma once

#include <vector>

#include "robot/coupled_newton.h"

namespace cdpr_kinetostatics {

// state: the pose to begin with; on success the equilibrium at these lengths [m], each cable on the rung given for it,
// stable and with every cable on its branch, linearised by newton, the robot's. rungs: bending ones.
SearchOutcome stiffen(const RobotDescription& robot, const Wrench& external, const std::vector<double>& lengths,
                      const std::vector<Model>& rungs, const CoupledOptions& options, CoupledNewton* newton,
                      CoupledState* state);

}  // namespace cdpr_kinetostatics

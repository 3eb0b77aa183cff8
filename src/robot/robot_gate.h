// The gate that every answer of a robot passes before it is called CONVERGED (docs/theory.md section 5, "The gate").
//
// Iterations stop because their steps have become small. That is no proof: this is.
#pragma once

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

// Whether the solution, whose residuals assemble() has summed anew, is an answer to the tolerance: all of its numbers
// are finite, every cable ends at its attachment, and forces and moments balance. CONVERGED without a word, or the code
// and the sentence that it deserves. Whatever its own status says is not looked at.
//
// solver_force [N]: what the solver's own tolerance of the pose makes of stiff cables, where it stops by the pose
// alone.
Status verdictOf(const RobotDescription& robot, const RobotSolution& solution, const Wrench& external, double tolerance,
                 double solver_force = 0.0);

// The part of it that looks at the balance alone.
Status balanceVerdict(const RobotDescription& robot, const RobotSolution& solution, const Wrench& external,
                      double tolerance, double solver_force = 0.0);

}  // namespace cdpr_kinetostatics

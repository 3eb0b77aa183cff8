// What every answer must hold, whatever was asked: checked anew from the answer's own numbers. A violation prints what
// was wrong and aborts, which the fuzzer reports together with its input.
#pragma once

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

// Prints the sentence and aborts unless the condition holds.
void require(bool condition, const char* sentence, const Status& status);

// No NaN and no infinity; a code that is set; a sentence unless it is CONVERGED.
void requireHonest(const CableSolution& solution);

// A converged cable ends where the same forces and length take it: textbook catenary, or problem 1 of the same model.
void requireClosed(const CableProperties& cable, const CableSolution& solution);

// The same for a robot, cables included; a converged one closes every cable and balances the load, summed anew.
void requireHonest(const RobotDescription& robot, const Wrench& external, const RobotSolution& solution);

void requireHonest(const RobotDescription& robot, const Estimate& estimate);

}  // namespace cdpr_kinetostatics

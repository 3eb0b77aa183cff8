// What the cables' rungs neglect, seen at the estimated pose.
#pragma once

#include "estimation/measured_robot.h"
#include "robot/rung_choice.h"

namespace cdpr_kinetostatics {

// Of the rungs that AUTO chooses from. Where measurements check each other, a rung whose error shows in them does not
// count as known. kept: the rungs in use, or empty; a coarser one must show half as much.
std::vector<RungEffects> rungEffects(const MeasuredRobot& measured, Candidate* candidate,
                                     const std::vector<Model>& kept);

// Of the rungs in use, into the report of a solution whose cables are assembled.
void reportEffect(const MeasuredRobot& measured, Candidate* candidate, RobotSolution* solution);

}  // namespace cdpr_kinetostatics

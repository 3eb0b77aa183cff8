// What the cables' rungs neglect, seen at the estimated pose.
#pragma once

#include "cdpr_kinetostatics/robot/rung_choice.h"
#include "measured_robot.h"

namespace cdpr_kinetostatics {

// Per cable: d(translation, rotation vector)/d(x, w), how the estimated pose moves if the cable's end lay elsewhere in
// its plane under the same forces [-, rad/m]. A direction that the data cannot fix does not move.
std::vector<Eigen::Matrix<double, 6, 2>> poseByEnd(const MeasuredRobot& measured, const Candidate& candidate);

// Of the rungs that AUTO chooses from.
std::vector<RungEffects> rungEffects(const MeasuredRobot& measured, const Candidate& candidate);

// Of the rungs in use, into the report of a solution whose cables are assembled.
void reportEffect(const MeasuredRobot& measured, const Candidate& candidate, RobotSolution* solution);

}  // namespace cdpr_kinetostatics

// Which measurements are at fault: data snooping, and mistrust of what jumps.
#pragma once

#include "measured_robot.h"

namespace cdpr_kinetostatics {

// Adjusts, and leaves out what is faulty, always from the same start. A gross error bends the whole estimate and
// shows in many residuals: which of the worst ones is at fault, leaving each out in turn tells.
Candidate leaveOutFaults(const MeasuredRobot& measured, const RobotForces& start, const Selection& selection);

// Leaves out what has jumped since the last estimate while most measurements have not: a drum's turn bends the
// estimate so far that its residual no longer tells it from others. What agrees in the end is taken back.
void leaveOutJumps(const MeasuredRobot& measured, const RobotForces& last, Selection* selection);

// Takes back, one by one, what was left out on suspicion and does not disturb.
void takeBack(const MeasuredRobot& measured, const RobotForces& start, Candidate* candidate);

// An adjustment that explains its measurements within what the threshold lets pass.
bool isGood(const Adjusted& adjusted, double threshold);

}  // namespace cdpr_kinetostatics

// Which measurements are at fault: data snooping, and mistrust of what jumps.
#pragma once

#include "estimation/measured_robot.h"

namespace cdpr_kinetostatics {

// Adjusts, and leaves out what is faulty, always from the same start. A gross error bends the whole estimate, shows in
// many residuals and least of all in its own: which one is at fault, leaving out each in turn tells, the likely ones
// first, until only noise is left.
Candidate leaveOutFaults(const MeasuredRobot& measured, const RobotForces& start, const Selection& selection);

// The same from the last estimate. What that left out, and what has jumped since while most measurements have not, is
// mistrusted at first and taken back, one by one, if it does not disturb: a drum's turn bends the estimate so far that
// its residual no longer tells it from others.
Candidate adjustFrom(const MeasuredRobot& measured, const RobotForces& last, const Selection& left_out);

// What the candidate leaves out of all that was measured or is known.
Selection leftOut(const MeasuredRobot& measured, const Candidate& candidate);

// A stable pose that explains the measurements within what the threshold lets pass, with most of the redundancy intact.
bool isTrusted(const MeasuredRobot& measured, const Candidate& candidate);

// Whether a is the better answer to the same measurements.
bool isBetter(const MeasuredRobot& measured, const Candidate& a, const Candidate& b);

}  // namespace cdpr_kinetostatics

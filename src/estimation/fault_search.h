// Which measurements are at fault: data snooping, and mistrust of what jumps.
#pragma once

#include "estimation/measured_robot.h"

namespace cdpr_kinetostatics {

// An error of which less than this share (the square of a hundredth) shows in its own residual cannot be told from
// others.
constexpr double kTestable = 1e-4;

// A residual in units of its own standard deviation; 0 if the others cannot check it.
double statistic(const Observation& observation);

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

// A stable pose that explains what is not left out as well as noise lets measurements be explained.
bool isNoise(const Candidate& candidate);

// The same, of all that was measured. No other start need then be tried. Any answer less than that may be owed to the
// start.
bool isBeyondDoubt(const MeasuredRobot& measured, const Candidate& candidate);

bool isSame(const Selection& a, const Selection& b);

// Takes an observation into the selection, or leaves it out.
void use(const Observation& observation, bool used, Selection* selection);

// Whether a is the better answer to the same measurements. How they were found plays no part.
bool isBetter(const MeasuredRobot& measured, const Candidate& a, const Candidate& b);

}  // namespace cdpr_kinetostatics

// Other faults that explain the measurements as well as those that were found: the data cannot tell which it is.
#pragma once

#include <vector>

#include "estimation/measured_robot.h"

namespace cdpr_kinetostatics {

// Adjustments with one of the faults exchanged for another. best becomes the likeliest of all, with what its faults
// would bring; the others are returned.
std::vector<Candidate> rivalsOf(const MeasuredRobot& measured, Candidate* best);

// Adjustments without a measurement that looks like a fault, but not so much that it is called one.
std::vector<Candidate> unprovenFaults(const MeasuredRobot& measured, const Candidate& best);

}  // namespace cdpr_kinetostatics

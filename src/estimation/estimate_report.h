// From an adjustment to what users get: pose with covariance, load, cables, residuals, faults.
#pragma once

#include <vector>

#include "estimation/measured_robot.h"

namespace cdpr_kinetostatics {

// rivals: other faults that explain the measurements as well, which are named. unproven: what looks like a fault. The
// covariance covers both.
Estimate report(const MeasuredRobot& measured, Candidate* candidate, const std::vector<Candidate>& rivals,
                const std::vector<Candidate>& unproven);

}  // namespace cdpr_kinetostatics

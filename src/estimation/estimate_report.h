// From an adjustment to what users get: pose with covariance, load, cables, residuals, faults.
#pragma once

#include "estimation/measured_robot.h"

namespace cdpr_kinetostatics {

Estimate report(const MeasuredRobot& measured, Candidate* candidate);

}  // namespace cdpr_kinetostatics

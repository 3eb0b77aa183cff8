// A simulated robot's measurements and truth as the parts of the estimator take them.
#pragma once

#include "estimation/measured_robot.h"
#include "simulated_measurements.h"

namespace cdpr_kinetostatics {

// All measurements and the whole load take part; with time enough. simulated and measurements must outlive the result.
MeasuredRobot measuredBy(const SimulatedRobot& simulated, const CableMeasurements& measurements);

RobotForces truthOf(const SimulatedRobot& simulated);

}  // namespace cdpr_kinetostatics

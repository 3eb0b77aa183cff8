// Whether a message can be this robot's at all: cheap enough to be known before anything is adjusted.
#pragma once

#include "cdpr_kinetostatics/cable/report.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"

namespace cdpr_kinetostatics {

// INVALID_INPUT, with a sentence that names the likely unit, where lengths or tensions as a whole are out of
// proportion to the robot. Single measurements never decide: finding these is the fault search's task.
Status checkPlausible(const RobotDescription& robot, const EstimatorOptions& options,
                      const CableMeasurements& measurements);

}  // namespace cdpr_kinetostatics

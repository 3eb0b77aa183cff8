// Homing: what a drive reports has an unknown zero. At a known pose the lengths that the cables must have there tell it
// (docs/node.md, ~home).
#pragma once

#include <vector>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "estimation/resting_samples.h"

namespace cdpr_kinetostatics {

struct HomingRequest {
  Pose pose;  // where the platform rests, known from elsewhere
  // With: each cable is as long as it must be there to have its measured tension. Without: as long as equilibrium says,
  // which a robot of more cables than freedoms does not fix.
  bool use_tensions = false;
};

struct Homing {
  RobotReport report;
  Pose pose;                        // with the attitude that balances, where that was left to equilibrium
  std::vector<double> corrections;  // to add to the offsets, in the robot's order [m]; empty unless CONVERGED
  std::vector<double> stddev;       // of the offsets, from the noise of what was measured [m]
};

// Of samples that were taken with the offsets to be corrected. The options are the estimator's: its deviations, its
// load, its models. Refuses a platform that moved, and a pose that the tensions contradict.
Homing findHome(const RobotDescription& robot, const EstimatorOptions& options, const HomingRequest& request,
                const RestingSamples& samples);

}  // namespace cdpr_kinetostatics

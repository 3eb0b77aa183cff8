// What the experiments of estimation_study have in common.
#pragma once

#include <string>
#include <vector>

#include "simulated_measurements.h"

namespace cdpr_kinetostatics {

struct Study {
  bool quick = false;
  std::string directory;  // of the CSV files
  Model model = Model::kCatenary;
};

// Normalised estimation errors of pose and load against their chi-square distribution.
void studyConsistency(const Study& study);
// One faulty sensor at a time: is it found, and does the estimate stay?
void studyFaults(const Study& study);
// Drums that are off by a little, one at a time or all at once.
void studyOffsets(const Study& study);
// A payload that comes and goes while the platform moves.
void studyLoadChange(const Study& study);
// Standard deviations, and what the measurements leave open.
void studyObservability(const Study& study);
// After random sequences of hostile messages: do ten good ones bring the answer of an estimator without a past?
void studyRecovery(const Study& study);
// Time of an update.
void studyTiming(const Study& study);

// What the estimator is given.
enum class Given { kAll, kLoadUnknown, kLengthsOnly };
constexpr Given kEveryGiven[] = {Given::kAll, Given::kLoadUnknown, Given::kLengthsOnly};
std::string nameOf(Given given);
// Sets up the estimator; what to give it of its measurements.
void configure(Given given, EstimatorOptions* options);
CableMeasurements given(Given what, CableMeasurements measurements);

// Names of the shipped robots.
std::vector<std::string> robots();
SimulatedRobot simulated(const Study& study, const std::string& robot);
// A robot at a random pose of its workspace that the cables can hold.
void moveToRandomPose(SimulatedRobot* robot);
// Level poses on a circle in the middle of the workspace, as the cables hold them.
std::vector<RobotSolution> circle(const SimulatedRobot& robot, int poses);

double sigma(const Eigen::Matrix<double, 6, 6>& covariance, int component);

}  // namespace cdpr_kinetostatics

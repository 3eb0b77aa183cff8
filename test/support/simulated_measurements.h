// A robot in equilibrium and what its sensors read, with noise: for tests and studies of the estimator.
#pragma once

#include <string>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {

struct SimulatedRobot {
  RobotDescription robot;
  EstimatorOptions estimator;  // deviations that fit the robot's size and weight
  RobotSolution truth;         // in equilibrium at a displaced and turned pose
  Dice dice{7};

  // Truth becomes the equilibrium at that pose, if the cables can hold it.
  bool moveTo(const Pose& pose);
  // Truth's cables under another load.
  RobotSolution under(const Wrench& load) const;
  // Within load_stddev.
  Wrench randomLoad();
  // noise: in units of the sensors' standard deviations.
  CableMeasurements measure(const RobotSolution& state, double noise);
};

// With deviations of 5e-5 of its span for lengths and 0.5 % of its weight for tensions. Throws if the robot cannot be
// held.
SimulatedRobot simulatedRobot(const RobotDescription& robot, Model model = Model::kCatenary);
// A robot of config/robots.
SimulatedRobot simulatedRobot(const std::string& robot_directory, const std::string& name,
                              Model model = Model::kCatenary);

// Translation and rotation vector, world axes, from the true pose to the estimated one.
Wrench poseError(const Pose& estimated, const Pose& truth);

}  // namespace cdpr_kinetostatics

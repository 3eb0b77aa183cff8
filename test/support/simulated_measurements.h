// Measurements of a robot in equilibrium, with noise, for tests of the estimator.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <string>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {

struct SimulatedRobot {
  RobotDescription robot;
  EstimatorOptions estimator;  // deviations that fit the robot's size and weight
  RobotSolution truth;         // in equilibrium at a displaced and turned pose
  std::mt19937 random{7};

  double normal() { return std::normal_distribution<double>()(random); }

  std::vector<double> lengths() const {
    std::vector<double> lengths;
    for (const CableResult& cable : truth.cables) lengths.push_back(cable.cable.length);
    return lengths;
  }

  // The same cables under another load.
  RobotSolution under(const Wrench& load) const {
    ForwardRequest request;
    request.lengths = lengths();
    request.external_wrench = load;
    request.seed = truth.pose;
    RobotSolverOptions options;
    options.model = estimator.model;
    options.timeout = estimator.timeout;
    return solveForward(robot, request, options);
  }

  Wrench randomLoad() {
    Wrench load = Wrench::Zero();
    for (int k = 0; k < robot.freedoms(); ++k) load(k) = estimator.load_stddev(k) * normal();
    return load;
  }

  CableMeasurements measure(const RobotSolution& state, double noise) {
    CableMeasurements measurements;
    for (const CableResult& cable : state.cables) {
      measurements.lengths.push_back(cable.cable.length + noise * estimator.length_stddev * normal());
      measurements.tensions.push_back(cable.cable.tension_a + noise * estimator.tension_stddev * normal());
    }
    return measurements;
  }
};

inline SimulatedRobot simulatedRobot(const std::string& name, Model model = Model::kCatenary) {
  SimulatedRobot simulated;
  simulated.robot = loadRobotFile(std::string(ROBOT_DIR) + "/" + name + ".yaml").robot;
  const RobotDescription& robot = simulated.robot;
  simulated.estimator.model = model;
  simulated.estimator.timeout = std::chrono::duration<double>(10.0);
  simulated.estimator.length_stddev = 5e-5 * robot.span();
  simulated.estimator.tension_stddev = 0.005 * robot.weight();
  simulated.estimator.load_stddev = EstimatorOptions::defaultLoadStddev(robot);
  InverseRequest request;
  request.pose = robot.home;
  const bool rigid = robot.type == PlatformType::kRigidBody;
  request.pose.position += 0.03 * robot.span() * Eigen::Vector3d(1.0, rigid ? 1.0 : 0.0, -0.5);
  if (rigid) {
    request.pose.orientation =
        Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.2, 0.1, 1.0).normalized()) * robot.home.orientation;
  }
  request.free_orientation = robot.cables.size() < 6;
  RobotSolverOptions options;
  options.model = model;
  options.timeout = simulated.estimator.timeout;
  simulated.truth = solveInverse(robot, request, options);
  EXPECT_TRUE(simulated.truth.report.status.ok()) << name << ": " << simulated.truth.report.status.message;
  return simulated;
}

// Translation and rotation vector, world axes, from the true pose to the estimated one.
inline Wrench poseError(const Pose& estimated, const Pose& truth) {
  Wrench error;
  const Eigen::AngleAxisd turn(estimated.orientation * truth.orientation.conjugate());
  const double angle = turn.angle() > M_PI ? turn.angle() - 2.0 * M_PI : turn.angle();
  error << estimated.position - truth.position, angle * turn.axis();
  return error;
}

}  // namespace cdpr_kinetostatics

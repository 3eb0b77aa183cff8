#include "simulated_measurements.h"

#include <cmath>
#include <stdexcept>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"

namespace cdpr_kinetostatics {

bool SimulatedRobot::moveTo(const Pose& pose) {
  RobotSolution there = solveInverse(robot, requestFor(robot, pose), patient(estimator.model));
  if (!there.report.status.ok()) return false;
  truth = there;
  return true;
}

RobotSolution SimulatedRobot::under(const Wrench& load) const {
  ForwardRequest request;
  request.lengths = lengthsOf(truth);
  request.external_wrench = load;
  request.seed = truth.pose;
  return solveForward(robot, request, patient(estimator.model));
}

Wrench SimulatedRobot::randomLoad() {
  Wrench load = Wrench::Zero();
  for (int k = 0; k < robot.freedoms(); ++k) load(k) = estimator.load_stddev(k) * dice.normal();
  return load;
}

CableMeasurements SimulatedRobot::measure(const RobotSolution& state, double noise) {
  CableMeasurements measurements;
  for (const CableResult& cable : state.cables) {
    measurements.lengths.push_back(cable.cable.length + noise * estimator.length_stddev * dice.normal());
    measurements.tensions.push_back(cable.cable.tension_a + noise * estimator.tension_stddev * dice.normal());
  }
  return measurements;
}

SimulatedRobot simulatedRobot(const std::string& robot_directory, const std::string& name, Model model) {
  return simulatedRobot(shippedRobot(robot_directory, name), model);
}

SimulatedRobot simulatedRobot(const RobotDescription& robot, Model model) {
  SimulatedRobot simulated;
  simulated.robot = robot;
  simulated.estimator.model = model;
  simulated.estimator.timeout = patient(model).timeout;
  simulated.estimator.length_stddev = 5e-5 * robot.span();
  simulated.estimator.tension_stddev = 0.005 * robot.weight();
  simulated.estimator.load_stddev = EstimatorOptions::defaultLoadStddev(robot);
  const bool rigid = robot.type == PlatformType::kRigidBody;
  // Less far and less turned, if that is more than the cables can hold.
  for (double share = 1.0; share > 1e-3; share *= 0.5) {
    Pose pose = robot.home;
    pose.position += share * 0.03 * robot.span() * Eigen::Vector3d(1.0, rigid ? 1.0 : 0.0, -0.5);
    if (rigid) {
      pose.orientation =
          Eigen::AngleAxisd(share * 0.3, Eigen::Vector3d(0.2, 0.1, 1.0).normalized()) * robot.home.orientation;
    }
    if (simulated.moveTo(pose)) return simulated;
  }
  throw std::runtime_error(robot.name + " cannot be held near its home");
}

Wrench poseError(const Pose& estimated, const Pose& truth) {
  Wrench error;
  const Eigen::AngleAxisd turn(estimated.orientation * truth.orientation.conjugate());
  const double angle = turn.angle() > M_PI ? turn.angle() - 2.0 * M_PI : turn.angle();
  error << estimated.position - truth.position, angle * turn.axis();
  return error;
}

}  // namespace cdpr_kinetostatics

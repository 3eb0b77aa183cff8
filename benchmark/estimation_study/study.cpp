#include "estimation_study/study.h"

#include <cmath>
#include <stdexcept>

namespace cdpr_kinetostatics {
namespace {

constexpr int kTrials = 2000;

// Attitudes of a workspace are made so much steeper: what depends on axes shows at large angles.
constexpr double kSteeper = 3.0;

}  // namespace

std::string nameOf(Given given) {
  switch (given) {
    case Given::kAll:
      return "all";
    case Given::kLoadUnknown:
      return "load unknown";
    case Given::kLengthsOnly:
      return "lengths only";
  }
  return "";
}

void configure(Given given, EstimatorOptions* options) { options->known_load = given != Given::kLoadUnknown; }

CableMeasurements given(Given what, CableMeasurements measurements) {
  if (what == Given::kLengthsOnly) {
    for (auto& tension : measurements.tensions) tension.reset();
  }
  return measurements;
}

std::vector<std::string> robots() {
  std::vector<std::string> names;
  for (const Workspace& workspace : shippedWorkspaces()) names.push_back(workspace.robot);
  return names;
}

SimulatedRobot simulated(const Study& study, const std::string& robot) {
  return simulatedRobot(ROBOT_DIR, robot, study.model);
}

void moveToRandomPose(SimulatedRobot* robot) {
  Workspace workspace = workspaceOf(robot->robot.name);
  workspace.tilt *= kSteeper;
  for (int k = 0; k < kTrials; ++k) {
    if (robot->moveTo(randomPose(workspace, &robot->dice))) return;
  }
  throw std::runtime_error(robot->robot.name + " cannot be held anywhere in its workspace");
}

std::vector<RobotSolution> circle(const SimulatedRobot& robot, int poses) {
  const Workspace workspace = workspaceOf(robot.robot.name);
  const Eigen::Vector3d middle = 0.5 * (workspace.low + workspace.high);
  const Eigen::Vector3d radius = 0.15 * (workspace.high - workspace.low);
  SimulatedRobot moving = robot;
  std::vector<RobotSolution> states;
  for (int k = 0; k < poses; ++k) {
    const double angle = 2.0 * M_PI * k / poses;
    Pose pose = robot.robot.home;
    pose.position = middle + Eigen::Vector3d(radius.x() * std::cos(angle), radius.y() * std::sin(angle),
                                             radius.z() * std::sin(angle));
    if (!moving.moveTo(pose)) throw std::runtime_error(robot.robot.name + " cannot be held on its circle");
    states.push_back(moving.truth);
  }
  return states;
}

double sigma(const Eigen::Matrix<double, 6, 6>& covariance, int component) {
  return std::sqrt(covariance(component, component));
}

}  // namespace cdpr_kinetostatics

// A robot and requests for it, made from the fuzzer's bytes.
#pragma once

#include <string>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "fuzzed_input.h"

namespace cdpr_kinetostatics {

inline Eigen::Vector3d fuzzedVector(FuzzedInput* input, double reach) {
  const double x = input->number(-reach, reach);
  const double y = input->number(-reach, reach);
  return {x, y, input->number(-reach, reach)};
}

inline Pose fuzzedPose(FuzzedInput* input, double reach) {
  Pose pose;
  pose.position = fuzzedVector(input, reach);
  if (input->flag()) {
    const double w = input->number(-1.0, 1.0);
    const Eigen::Vector3d xyz = fuzzedVector(input, 1.0);
    pose.orientation = Eigen::Quaterniond(w, xyz.x(), xyz.y(), xyz.z());
    if (pose.orientation.norm() > 1e-3) pose.orientation.normalize();
  }
  return pose;
}

inline Wrench fuzzedWrench(FuzzedInput* input) {
  Wrench wrench = Wrench::Zero();
  if (input->flag()) wrench << fuzzedVector(input, 1e3), fuzzedVector(input, 1e2);
  return wrench;
}

// Anchors around and above the platform, mostly, so that many requests have an answer.
inline RobotDescription fuzzedRobot(FuzzedInput* input) {
  RobotDescription robot;
  robot.name = "fuzzed";
  robot.type = input->flag() ? PlatformType::kRigidBody : PlatformType::kPointMass;
  robot.mass = input->magnitude(1e-2, 1e3);
  if (robot.type == PlatformType::kRigidBody) robot.com = fuzzedVector(input, 0.2);
  robot.home.position = Eigen::Vector3d(0.0, 0.0, 1.0);
  const CableProperties common = input->cable();
  const int count = input->count(1, 10);
  for (int i = 0; i < count; ++i) {
    CableDescription cable;
    cable.name = "cable" + std::to_string(i);
    const double angle = 6.283 * i / count;
    cable.anchor = Eigen::Vector3d(4.0 * std::cos(angle), 4.0 * std::sin(angle), 4.0) + fuzzedVector(input, 1.0);
    if (robot.type == PlatformType::kRigidBody) cable.attachment = fuzzedVector(input, 0.5);
    cable.properties = input->flag() ? common : input->cable();
    cable.tension_min = input->flag() ? 0.0 : input->magnitude(1e-2, 1e3);
    cable.tension_max = cable.tension_min + input->magnitude(1.0, 1e5);
    robot.cables.push_back(cable);
  }
  return robot;
}

}  // namespace cdpr_kinetostatics

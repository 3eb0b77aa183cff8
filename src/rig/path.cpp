#include "rig/path.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {

namespace {

constexpr double kTurnRate = 0.2;  // of pure turns [rad/s]

double timeBetween(const Pose& from, const Pose& to, double speed) {
  return std::max((to.position - from.position).norm() / speed,
                  from.orientation.angularDistance(to.orientation) / kTurnRate);
}

Pose between(const Pose& from, const Pose& to, double share) {
  Pose pose;
  pose.position = from.position + share * (to.position - from.position);
  pose.orientation = from.orientation.slerp(share, to.orientation);
  return pose;
}

}  // namespace

FixedPath::FixedPath(const RobotDescription& robot, const RigPath& path, double radius)
    : path_(path),
      radius_(radius),
      home_(robot.home),
      first_(Eigen::Vector3d::UnitX()),
      second_(Eigen::Vector3d::UnitY()) {
  if (robot.type != PlatformType::kPointMass || robot.cables.size() != 2) return;
  Eigen::Vector3d across = robot.cables[1].anchor - robot.cables[0].anchor;
  across.z() = 0.0;
  if (across.norm() > 0.0) first_ = across.normalized();
  second_ = Eigen::Vector3d::UnitZ();
}

double FixedPath::duration() const {
  if (path_.kind != RigPath::Kind::kWaypoints) return path_.period;
  double duration = 0.0;
  for (std::size_t i = 0; i < path_.waypoints.size(); ++i) {
    duration += timeBetween(path_.waypoints[i], path_.waypoints[(i + 1) % path_.waypoints.size()], path_.speed);
  }
  return duration;
}

Pose FixedPath::onCurve(double phase) const {
  Pose pose = home_;
  if (path_.kind == RigPath::Kind::kCircle) {
    pose.position += radius_ * (std::sin(phase) * first_ + (1.0 - std::cos(phase)) * second_);
  } else {
    pose.position += radius_ * (std::sin(phase) * first_ + std::sin(phase) * std::cos(phase) * second_);
  }
  return pose;
}

Pose FixedPath::alongWaypoints(double time) const {
  double left = std::fmod(time, std::max(duration(), 1e-9));
  for (std::size_t i = 0; i < path_.waypoints.size(); ++i) {
    const Pose& from = path_.waypoints[i];
    const Pose& to = path_.waypoints[(i + 1) % path_.waypoints.size()];
    const double leg = timeBetween(from, to, path_.speed);
    if (left < leg) return between(from, to, left / leg);
    left -= leg;
  }
  return path_.waypoints.front();
}

Pose FixedPath::at(double time) const {
  switch (path_.kind) {
    case RigPath::Kind::kCircle:
    case RigPath::Kind::kFigureOfEight:
      return onCurve(2.0 * M_PI * time / path_.period);
    case RigPath::Kind::kWaypoints:
      return alongWaypoints(time);
    case RigPath::Kind::kTarget:
      break;
  }
  return home_;
}

Pose stepTowards(const Pose& from, const Pose& target, double speed, double step) {
  const double needed = timeBetween(from, target, speed);
  return needed <= step ? target : between(from, target, step / needed);
}

}  // namespace cdpr_kinetostatics

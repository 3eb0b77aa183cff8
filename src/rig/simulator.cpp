#include "rig/simulator.h"

#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cable/text.h"
#include "rig/load.h"
#include "rig/step_clock.h"
#include "ros/clock_watch.h"
#include "ros/conversions.h"
#include "ros/markers.h"
#include "ros/request_checks.h"

namespace cdpr_kinetostatics {

namespace {

constexpr double kDefaultRadius = 0.05;  // of the path [spans of the frame]
constexpr double kMarkerSize = 0.1;      // [spans of the frame]

visualization_msgs::InteractiveMarkerControl control(const Eigen::Vector3d& axis, std::uint8_t mode,
                                                     const std::string& name) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), axis);
  visualization_msgs::InteractiveMarkerControl c;
  c.orientation = toMsg(Pose{Eigen::Vector3d::Zero(), turn}).orientation;
  c.interaction_mode = mode;
  c.name = name;
  return c;
}

}  // namespace

RigSimulator::RigSimulator(ros::NodeHandle handle, ros::NodeHandle private_handle, const RigParameters& parameters)
    : parameters_(parameters),
      path_(choosePath()),
      lap_(stepsOfLap()),
      measurements_(parameters.robot, parameters.sensors),
      pose_(parameters.robot.home),
      target_(parameters.robot.home) {
  cable_states_ = handle.advertise<sensor_msgs::JointState>("cable_states", 100);
  true_pose_ = handle.advertise<geometry_msgs::PoseStamped>("true_pose", 100);
  true_platform_ = private_handle.advertise<visualization_msgs::Marker>("platform", 1);
  if (parameters.path.kind == RigPath::Kind::kTarget) {
    const boost::function<void(const geometry_msgs::PoseStamped&)> callback =
        [this](const geometry_msgs::PoseStamped& target) { setTarget(target); };
    target_pose_ = handle.subscribe<geometry_msgs::PoseStamped>("target_pose", 10, callback);
    offerTargetMarker();
  }
}

bool RigSimulator::canBeHeld(const FixedPath& path) const {
  constexpr int kPoses = 16;  // at equal times along the path
  for (int k = 0; k < kPoses; ++k) {
    RigTruth truth;
    const Pose pose = path.at(path.duration() * k / kPoses);
    if (!solveRig(parameters_, pose, Wrench::Zero(), Model::kCatenary, &truth).ok()) return false;
  }
  return true;
}

FixedPath RigSimulator::choosePath() const {
  constexpr int kHalvings = 6;  // down to a sixty-fourth of the default radius
  double radius = parameters_.path.radius.value_or(kDefaultRadius * parameters_.robot.span());
  if (parameters_.path.radius) return FixedPath(parameters_.robot, parameters_.path, radius);
  for (int k = 0; k < kHalvings; ++k, radius *= 0.5) {
    FixedPath path(parameters_.robot, parameters_.path, radius);
    if (!canBeHeld(path)) continue;
    ROS_INFO_STREAM("path of radius " << radius << " m");
    return path;
  }
  throw std::invalid_argument(text("robot ", parameters_.robot.name,
                                   " cannot hold the path: give a smaller ~path_radius, or another home or waypoints"));
}

void RigSimulator::setTarget(const geometry_msgs::PoseStamped& target) {
  const std::string& frame = target.header.frame_id;
  try {
    if (!frame.empty() && frame != parameters_.base_frame) {
      throw RequestError(text("header.frame_id is '", frame, "': expected '", parameters_.base_frame, "', or none"));
    }
    target_ = checkedPose("pose", target.pose);
  } catch (const RequestError& problem) {
    ROS_WARN_STREAM("target_pose ignored: " << problem.what());
  }
}

void RigSimulator::offerTargetMarker() {
  using Control = visualization_msgs::InteractiveMarkerControl;
  target_marker_ = std::make_unique<interactive_markers::InteractiveMarkerServer>("target_marker");
  visualization_msgs::InteractiveMarker marker;
  marker.header.frame_id = parameters_.base_frame;
  marker.name = "target";
  marker.description = "drag the platform";
  marker.scale = static_cast<float>(kMarkerSize * parameters_.robot.span());
  marker.pose = toMsg(parameters_.robot.home);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
    marker.controls.push_back(control(axis, Control::MOVE_AXIS, text("move", k)));
    if (parameters_.robot.cables.size() >= 6) {
      marker.controls.push_back(control(axis, Control::ROTATE_AXIS, text("turn", k)));
    }
  }
  target_marker_->insert(marker, [this](const visualization_msgs::InteractiveMarkerFeedbackConstPtr& feedback) {
    geometry_msgs::PoseStamped target;
    target.header = feedback->header;
    target.pose = feedback->pose;
    setTarget(target);
  });
  target_marker_->applyChanges();
}

// The number of steps of a lap; 0 if laps differ, if a lap is not a whole number of steps, or if it is too long to be
// remembered.
std::size_t RigSimulator::stepsOfLap() const {
  constexpr double kMost = 100000;  // steps, of some hundred bytes each
  const double steps = path_.duration() * parameters_.rate;
  const bool whole = std::abs(steps - std::round(steps)) < 1e-9 * steps;
  const bool same = parameters_.path.kind != RigPath::Kind::kTarget && parameters_.load_noise == 0.0;
  return same && whole && steps < kMost ? static_cast<std::size_t>(std::round(steps)) : 0;
}

Pose RigSimulator::wantedPose(std::uint64_t step) const {
  if (parameters_.path.kind != RigPath::Kind::kTarget) return path_.at(static_cast<double>(step) / parameters_.rate);
  return stepTowards(pose_, target_, parameters_.path.speed, 1.0 / parameters_.rate);
}

std::optional<RigTruth> RigSimulator::truthAt(std::uint64_t step) {
  const double time = static_cast<double>(step) / parameters_.rate;
  const Wrench load = rigLoad(parameters_, time);
  const Pose wanted = wantedPose(step);
  if (const RigTruth* known = lap_.find(step, load)) {
    pose_ = wanted;
    return *known;
  }
  RigTruth truth;
  Status status = solveRig(parameters_, wanted, load, parameters_.model, &truth);
  if (status.ok()) {
    pose_ = wanted;
    lap_.remember(step, load, truth);
  } else {
    ROS_WARN_STREAM_THROTTLE(5.0, "the platform stays where it is: " << status.message);
    status = solveRig(parameters_, pose_, load, parameters_.model, &truth);
  }
  if (status.ok() && parameters_.load_noise > 0.0) {
    status = disturbRig(parameters_, load + unknownRigLoad(parameters_, time), &truth);
  }
  if (status.ok()) return truth;
  ROS_WARN_STREAM_THROTTLE(5.0, "no measurement: " << status.message);
  return std::nullopt;
}

void RigSimulator::showPlatform(const geometry_msgs::PoseStamped& pose) const {
  if (true_platform_.getNumSubscribers() == 0) return;
  true_platform_.publish(platformOutline(parameters_.robot, pose.header, pose.pose));
}

void RigSimulator::step(std::uint64_t step) {
  const std::optional<RigTruth> truth = truthAt(step);
  if (!truth) return;
  geometry_msgs::PoseStamped pose;
  pose.header.stamp = ros::Time::now();
  pose.header.frame_id = parameters_.base_frame;
  pose.pose = toMsg(truth->pose);
  true_pose_.publish(pose);
  showPlatform(pose);
  if (auto message = measurements_.measure(*truth, static_cast<double>(step) / parameters_.rate)) {
    message->header = pose.header;
    cable_states_.publish(*message);
  }
}

void RigSimulator::run() {
  constexpr double kLongestWait = 0.1;     // [s], after which it is seen whether the node was shut down
  constexpr double kSimulatedWait = 1e-3;  // [s], to look at a clock whose speed is not known
  StepClock clock(parameters_.rate);
  std::uint64_t n = 0;
  while (ros::ok()) {
    const double now = ros::Time::now().toSec();
    if (!isTimeMissing() && clock.isDue(now)) {
      step(n++);
      ros::spinOnce();
      continue;
    }
    const double wait = ros::Time::isSimTime() ? kSimulatedWait : std::min(clock.timeOfNext() - now, kLongestWait);
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(wait));
  }
}

}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/ros/rig_simulator.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/rate.h>
#include <sensor_msgs/JointState.h>

#include <stdexcept>

#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/ros/conversions.h"
#include "cdpr_kinetostatics/ros/markers.h"
#include "cdpr_kinetostatics/ros/request_checks.h"
#include "cdpr_kinetostatics/ros/text.h"

namespace cdpr_kinetostatics {

namespace {

constexpr double kDefaultRadius = 0.05;  // in spans of the frame
constexpr double kMarkerSize = 0.1;      // in spans of the frame
constexpr double kTruthScale = 1.03;     // so that the estimate does not hide it

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

RobotSolution RigSimulator::solve(const Pose& pose, const Wrench& load, Model model) const {
  const RobotDescription& robot = parameters_.robot;
  InverseRequest request;
  request.pose = pose;
  request.free_orientation = robot.type == PlatformType::kRigidBody && robot.cables.size() < 6;
  request.external_wrench = load;
  RobotSolverOptions options;
  options.model = model;
  options.tolerance = parameters_.tolerance;
  options.timeout = std::chrono::duration<double>(5.0);
  return solveInverse(robot, request, options);
}

Wrench RigSimulator::loadAt(double time) const {
  Wrench load = Wrench::Zero();
  for (const RigLoad& step : parameters_.loads) {
    if (step.time <= time) load = step.wrench;
  }
  return load;
}

bool RigSimulator::canBeHeld(const FixedPath& path) const {
  constexpr int kPoses = 16;
  for (int k = 0; k < kPoses; ++k) {
    const RobotSolution solution = solve(path.at(path.duration() * k / kPoses), Wrench::Zero(), Model::kCatenary);
    if (!solution.report.status.ok()) return false;
  }
  return true;
}

FixedPath RigSimulator::choosePath() const {
  constexpr int kHalvings = 6;
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
    checkPose("pose", target.pose);
    target_ = fromMsg(target.pose);
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

Pose RigSimulator::wantedPose(double time) {
  if (parameters_.path.kind != RigPath::Kind::kTarget) return path_.at(time);
  return stepTowards(pose_, target_, parameters_.path.speed, 1.0 / parameters_.rate);
}

void RigSimulator::step(double time) {
  const Pose wanted = wantedPose(time);
  RobotSolution truth = solve(wanted, loadAt(time), parameters_.model);
  if (truth.report.status.ok()) {
    pose_ = wanted;
  } else {
    ROS_WARN_STREAM_THROTTLE(5.0, "the platform stays where it is: " << truth.report.status.message);
    truth = solve(pose_, loadAt(time), parameters_.model);
    if (!truth.report.status.ok()) return;
  }
  geometry_msgs::PoseStamped pose;
  pose.header.stamp = ros::Time::now();
  pose.header.frame_id = parameters_.base_frame;
  pose.pose = toMsg(truth.pose);
  true_pose_.publish(pose);
  if (true_platform_.getNumSubscribers() > 0) {
    visualization_msgs::Marker platform = platformMarker(parameters_.robot, pose.header, pose.pose);
    platform.color = rgba(0.2, 0.9, 0.3, 0.35);
    platform.scale.x *= kTruthScale;
    platform.scale.y *= kTruthScale;
    platform.scale.z *= kTruthScale;
    true_platform_.publish(platform);
  }
  if (auto message = measurements_.measure(truth.cables, time)) {
    message->header = pose.header;
    cable_states_.publish(*message);
  }
}

void RigSimulator::run() {
  ros::Rate rate(parameters_.rate);
  for (std::uint64_t n = 0; ros::ok(); ++n) {
    step(static_cast<double>(n) / parameters_.rate);
    ros::spinOnce();
    rate.sleep();
  }
}

}  // namespace cdpr_kinetostatics

// What the node does with a message, without a master: check, estimate, convert, serialise. And the messages of a robot
// that goes around, with noise and now and then a fault.
#pragma once

#include <ros/serialization.h>
#include <sensor_msgs/JointState.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"
#include "ros/estimate_message.h"
#include "ros/estimator_status.h"
#include "ros/markers.h"
#include "ros/measurement_input.h"

namespace cdpr_kinetostatics {

// A lap of the platform around its home, measured 50 times a second.
class MessageStream {
 public:
  MessageStream(const RobotDescription& robot, Model model) {
    constexpr int kLap = 100;
    for (int i = 0; i < kLap; ++i) {
      const double turn = 2.0 * M_PI * i / kLap;
      Pose pose = robot.home;
      pose.position += 0.02 * robot.span() * Eigen::Vector3d(std::cos(turn), std::sin(turn), 0.0);
      const RobotSolution there = solveInverse(robot, requestFor(robot, pose), patient(model));
      if (!there.report.status.ok()) throw std::runtime_error(there.report.status.message);
      sensor_msgs::JointState message;
      for (const CableResult& cable : there.cables) {
        message.name.push_back(cable.name);
        message.position.push_back(cable.cable.length);
        message.effort.push_back(cable.cable.tension_a);
      }
      lap_.push_back(message);
    }
  }

  static constexpr double kRate = 50.0;  // [Hz]

  sensor_msgs::JointState next() {
    sensor_msgs::JointState message = lap_[count_ % lap_.size()];
    message.header.stamp = ros::Time(1.0 + static_cast<double>(count_) / kRate);
    ++count_;
    for (double& length : message.position) length += 1e-3 * normal_(random_);
    for (double& tension : message.effort) tension += 2.0 * normal_(random_);
    if (count_ % 97 == 0) message.position[count_ % message.position.size()] += 0.3;
    if (count_ % 89 == 0) message.effort[0] = std::numeric_limits<double>::quiet_NaN();
    if (count_ % 83 == 0) message.name.pop_back();
    if (count_ % 79 == 0) message.header.stamp = ros::Time(1.0);
    return message;
  }

 private:
  std::vector<sensor_msgs::JointState> lap_;
  std::size_t count_ = 0;
  std::mt19937 random_{3};
  std::normal_distribution<double> normal_;
};

class NodePath {
 public:
  // The robot must outlive the path.
  NodePath(const RobotDescription& robot, const EstimatorOptions& options)
      : robot_(robot), input_(robot, 0.5), estimator_(robot, options) {}

  void process(const sensor_msgs::JointState& message, const ros::Time& now) {
    const auto measurement = input_.check(message, now);
    if (!measurement) return;
    if (measurement->reset_first) estimator_.reset();
    const Estimate estimate = estimator_.update(measurement->cables);
    const KinetostaticState state = toMsg(estimate, *measurement, robot_, "world");
    status_.add(estimate, state);
    bytes_ += ros::serialization::serializeMessage(poseOf(state)).num_bytes;
    bytes_ += ros::serialization::serializeMessage(loadOf(state)).num_bytes;
    bytes_ += ros::serialization::serializeMessage(transformOf(state, "platform")).num_bytes;
    bytes_ += ros::serialization::serializeMessage(state).num_bytes;
    bytes_ += ros::serialization::serializeMessage(cableMarkers(robot_, state)).num_bytes;
    if (status_.recent_solves >= 50) status_.startAnew();
  }

  const InputCounts& counts() const { return input_.counts(); }
  const EstimatorStatus& status() const { return status_; }
  std::size_t bytes() const { return bytes_; }

 private:
  const RobotDescription& robot_;
  MeasurementInput input_;
  PoseEstimator estimator_;
  EstimatorStatus status_;
  std::size_t bytes_ = 0;  // of messages
};

}  // namespace cdpr_kinetostatics

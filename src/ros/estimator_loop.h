// Runs the estimator: from the messages on cable_states to published estimates, in two threads of its own.
//
// One receives, checks and queues; one estimates and publishes. Services reach the estimator between two solves.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <mutex>
#include <thread>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "ros/estimate_output.h"
#include "ros/estimator_status.h"
#include "ros/measurement_input.h"
#include "ros/measurement_queue.h"
#include "ros/parameters.h"

namespace cdpr_kinetostatics {

class EstimatorLoop {
 public:
  // The parameters must outlive the loop.
  EstimatorLoop(const ros::NodeHandle& handle, const NodeParameters& parameters);
  ~EstimatorLoop();
  EstimatorLoop(const EstimatorLoop&) = delete;
  EstimatorLoop& operator=(const EstimatorLoop&) = delete;

  // What is known is forgotten, and measurements that wait are dropped: the next estimate starts from the home pose,
  // or from the seed.
  void reset();
  void setPose(const Pose& seed);

  struct InputStatus {
    std::string topic;
    std::uint32_t publishers = 0;
    InputCounts counts;
    std::uint64_t superseded = 0;
    std::string last_problem;
    ros::WallTime last_arrival;  // zero: nothing yet
  };
  InputStatus inputStatus() const;
  // Starts the recent counts anew.
  EstimatorStatus takeEstimatorStatus();

 private:
  void receive(const sensor_msgs::JointStateConstPtr& message);
  void estimate();

  const NodeParameters& parameters_;
  EstimateOutput output_;

  mutable std::mutex input_mutex_;  // guards input_ and last_arrival_
  MeasurementInput input_;
  ros::WallTime last_arrival_;

  MeasurementQueue queue_;

  std::mutex estimator_mutex_;  // guards estimator_; held during a solve
  PoseEstimator estimator_;

  std::mutex status_mutex_;  // guards status_
  EstimatorStatus status_;

  ros::CallbackQueue callbacks_;
  ros::Subscriber subscriber_;
  ros::AsyncSpinner receiver_;
  std::thread worker_;
};

}  // namespace cdpr_kinetostatics

// Runs the estimator: from the messages on cable_states to published estimates, in two threads of its own.
//
// One receives, checks and queues; one estimates and publishes. Services reach the estimator between two solves.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <chrono>
#include <mutex>
#include <thread>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "ros/estimate_output.h"
#include "ros/estimator_status.h"
#include "ros/measurement_input.h"
#include "ros/measurement_queue.h"
#include "ros/parameters.h"
#include "ros/sample_collector.h"

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

  // The next measurements, at most so many, until the time is up. The caller waits for them in a thread of its own:
  // receiving and estimating go on. What is missing shows in their number.
  RestingSamples collect(std::size_t most, std::chrono::duration<double> window);

  // Adds corrections to the offsets of the lengths that arrive from now on [m], and starts anew from the pose. Returns
  // the offsets.
  std::vector<double> correctOffsets(const std::vector<double>& corrections, const Pose& seed);

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

  SampleCollector collector_;

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

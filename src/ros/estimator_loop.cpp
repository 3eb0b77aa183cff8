#include "ros/estimator_loop.h"

#include <ros/console.h>
#include <ros/init.h>

#include "ros/estimate_message.h"
#include "ros/service_reply.h"

namespace cdpr_kinetostatics {

namespace {

// Receiving takes microseconds: a queue of this length does not overflow.
constexpr std::uint32_t kReceiveQueue = 10000;

}  // namespace

EstimatorLoop::EstimatorLoop(const ros::NodeHandle& handle, const NodeParameters& parameters)
    : parameters_(parameters),
      output_(handle, parameters),
      input_(parameters.robot, parameters.max_age),
      collector_(parameters.robot.cables.size()),
      queue_(static_cast<std::size_t>(parameters.queue_size)),
      estimator_(parameters.robot, parameters.estimator),
      receiver_(1, &callbacks_) {
  ros::NodeHandle own(handle);
  own.setCallbackQueue(&callbacks_);
  subscriber_ =
      own.subscribe("cable_states", kReceiveQueue, &EstimatorLoop::receive, this, ros::TransportHints().tcpNoDelay());
  receiver_.start();
  worker_ = std::thread([this] { estimate(); });
}

EstimatorLoop::~EstimatorLoop() {
  receiver_.stop();
  subscriber_.shutdown();
  queue_.close();
  worker_.join();
}

void EstimatorLoop::receive(const sensor_msgs::JointStateConstPtr& message) {
  const std::lock_guard<std::mutex> lock(input_mutex_);
  last_arrival_ = ros::WallTime::now();
  const std::uint64_t refused = input_.counts().refused();
  if (auto measurement = input_.check(*message, ros::Time::now())) {
    if (measurement->reset_first) ROS_WARN("cable_states: time went backwards; the estimator starts anew");
    collector_.add(measurement->cables);
    queue_.push(std::move(*measurement));
  }
  if (input_.counts().refused() > refused) {
    ROS_WARN_STREAM_THROTTLE(5.0, "cable_states: refused: " << input_.lastProblem());
  }
}

void EstimatorLoop::estimate() {
  while (const auto measurement = queue_.pop()) {
    Estimate estimate;
    {
      const std::lock_guard<std::mutex> lock(estimator_mutex_);
      if (measurement->reset_first) estimator_.reset();
      try {
        estimate = estimator_.update(measurement->cables);
      } catch (const std::exception& problem) {
        estimator_.reset();
        estimate.solution.report.status = {Code::kInternalError, problem.what()};
      }
    }
    const KinetostaticState state = toMsg(estimate, *measurement, parameters_.robot, parameters_.base_frame);
    if (state.report.code != SolveReport::CONVERGED) {
      ROS_WARN_STREAM_THROTTLE(5.0, "no estimate: code " << state.report.code << ", " << state.report.message);
    }
    output_.publish(state);
    const std::lock_guard<std::mutex> lock(status_mutex_);
    status_.add(estimate, state);
  }
}

void EstimatorLoop::reset() {
  const std::lock_guard<std::mutex> input_lock(input_mutex_);
  input_.reset();
  queue_.clear();
  const std::lock_guard<std::mutex> estimator_lock(estimator_mutex_);
  estimator_.reset();
}

void EstimatorLoop::setPose(const Pose& seed) {
  const std::lock_guard<std::mutex> input_lock(input_mutex_);
  queue_.clear();
  const std::lock_guard<std::mutex> estimator_lock(estimator_mutex_);
  estimator_.setPose(seed);
}

RestingSamples EstimatorLoop::collect(std::size_t most, std::chrono::duration<double> window) {
  return collector_.collect(most, window, [] { return ros::ok(); });
}

std::vector<double> EstimatorLoop::correctOffsets(const std::vector<double>& corrections, const Pose& seed) {
  const std::lock_guard<std::mutex> input_lock(input_mutex_);
  std::vector<double> offsets = input_.offsets();
  for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] += corrections[i];
  input_.setOffsets(offsets);
  queue_.clear();
  const std::lock_guard<std::mutex> estimator_lock(estimator_mutex_);
  estimator_.setPose(seed);
  return offsets;
}

EstimatorLoop::InputStatus EstimatorLoop::inputStatus() const {
  InputStatus status;
  status.topic = subscriber_.getTopic();
  status.publishers = subscriber_.getNumPublishers();
  status.superseded = queue_.superseded();
  const std::lock_guard<std::mutex> lock(input_mutex_);
  status.counts = input_.counts();
  status.last_problem = input_.lastProblem();
  status.last_arrival = last_arrival_;
  return status;
}

EstimatorStatus EstimatorLoop::takeEstimatorStatus() {
  const std::lock_guard<std::mutex> lock(status_mutex_);
  EstimatorStatus taken = status_;
  status_.startAnew();
  return taken;
}

}  // namespace cdpr_kinetostatics

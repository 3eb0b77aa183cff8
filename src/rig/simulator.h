// A simulated robot: moves its platform along a path and says what its sensors would say.
//
// The n-th message belongs to the n-th step of 1/rate, however long the solves take: the same parameters give the same
// numbers in every run.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <interactive_markers/interactive_marker_server.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>

#include <memory>
#include <optional>

#include "rig/parameters.h"
#include "rig/path.h"
#include "rig/sensors.h"
#include "rig/truth.h"

namespace cdpr_kinetostatics {

class RigSimulator {
 public:
  // Throws std::invalid_argument if the path cannot be held. The parameters must outlive the rig.
  RigSimulator(ros::NodeHandle handle, ros::NodeHandle private_handle, const RigParameters& parameters);

  // Until the node is shut down.
  void run();

 private:
  bool canBeHeld(const FixedPath& path) const;
  FixedPath choosePath() const;
  std::size_t stepsOfLap() const;
  Pose wantedPose(std::uint64_t step) const;
  std::optional<RigTruth> truthAt(std::uint64_t step);
  void setTarget(const geometry_msgs::PoseStamped& target);
  void offerTargetMarker();
  void showPlatform(const geometry_msgs::PoseStamped& pose) const;
  void step(std::uint64_t step);

  const RigParameters& parameters_;
  FixedPath path_;
  RigLap lap_;
  RigMeasurements measurements_;
  Pose pose_;    // where the platform was last
  Pose target_;  // with the path `target`
  ros::Publisher cable_states_, true_pose_, true_platform_;
  ros::Subscriber target_pose_;
  std::unique_ptr<interactive_markers::InteractiveMarkerServer> target_marker_;
};

}  // namespace cdpr_kinetostatics

// Publishes estimates: pose, load, state, markers and the transform of the platform.
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/transform_broadcaster.h>

#include "cdpr_kinetostatics/KinetostaticState.h"
#include "ros/parameters.h"

namespace cdpr_kinetostatics {

class EstimateOutput {
 public:
  // The parameters must outlive the output.
  EstimateOutput(ros::NodeHandle handle, const NodeParameters& parameters);

  // A state whose code is not CONVERGED goes to kinetostatic_state alone.
  void publish(const KinetostaticState& state);

 private:
  bool markersAreDue(const ros::Time& stamp);

  const NodeParameters& parameters_;
  ros::Publisher pose_, load_, state_, markers_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Time last_markers_;
};

}  // namespace cdpr_kinetostatics

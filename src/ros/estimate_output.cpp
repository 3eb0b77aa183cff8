#include "ros/estimate_output.h"

#include "ros/estimate_message.h"
#include "ros/markers.h"

namespace cdpr_kinetostatics {

EstimateOutput::EstimateOutput(ros::NodeHandle handle, const NodeParameters& parameters) : parameters_(parameters) {
  constexpr std::uint32_t kQueue = 100;
  pose_ = handle.advertise<geometry_msgs::PoseWithCovarianceStamped>("platform_pose", kQueue);
  load_ = handle.advertise<geometry_msgs::WrenchStamped>("platform_load", kQueue);
  state_ = handle.advertise<KinetostaticState>("kinetostatic_state", kQueue);
  markers_ = handle.advertise<visualization_msgs::MarkerArray>("cable_markers", 1);
}

bool EstimateOutput::markersAreDue(const ros::Time& stamp) {
  if (parameters_.marker_rate <= 0.0 || markers_.getNumSubscribers() == 0) return false;
  // One per cent early counts as in time, because stamps need not be exact multiples of the period.
  const double since = stamp.toSec() - last_markers_.toSec();
  if (!last_markers_.isZero() && since >= 0.0 && since < 0.99 / parameters_.marker_rate) return false;
  last_markers_ = stamp;
  return true;
}

void EstimateOutput::publish(const KinetostaticState& state) {
  // The pose first: it is what controllers wait for, and the state takes longest.
  const bool converged = state.report.code == SolveReport::CONVERGED;
  if (converged) {
    pose_.publish(poseOf(state));
    load_.publish(loadOf(state));
    if (parameters_.publish_tf) broadcaster_.sendTransform(transformOf(state, parameters_.platform_frame));
  }
  state_.publish(state);
  if (converged && markersAreDue(state.header.stamp)) markers_.publish(cableMarkers(parameters_.robot, state));
}

}  // namespace cdpr_kinetostatics

#include "ros/estimate_message.h"

#include <algorithm>

#include "ros/conversions.h"
#include "ros/service_reply.h"

namespace cdpr_kinetostatics {

namespace {

geometry_msgs::Wrench wrenchMsg(const Wrench& wrench) {
  geometry_msgs::Wrench converted;
  converted.force = toVector3(wrench.head<3>());
  converted.torque = toVector3(wrench.tail<3>());
  return converted;
}

bool isFinite(const KinetostaticState& state) {
  const auto& covariance = state.pose.covariance;
  const auto& force = state.load.force;
  const auto& torque = state.load.torque;
  return allFinite(state.report) && allFinite(state.pose.pose) && allFinite(state.cables) &&
         allFinite(std::vector<double>(covariance.begin(), covariance.end())) &&
         allFinite({force.x, force.y, force.z, torque.x, torque.y, torque.z}) && allFinite(state.length_residual) &&
         allFinite(state.tension_residual);
}

KinetostaticState withoutPose(const RobotDescription& robot) {
  KinetostaticState state;
  state.pose.pose = toMsg(robot.home);
  for (std::size_t i = 0; i < 6; ++i) state.pose.covariance[7 * i] = kUnknownVariance;
  return state;
}

KinetostaticState fromEstimate(const Estimate& estimate, const CableMeasurements& measured) {
  KinetostaticState state;
  state.report = toMsg(estimate.solution.report);
  state.report.warm_started = estimate.warm_started;
  state.pose.pose = toMsg(estimate.solution.pose);
  const std::vector<double> covariance = toMsg(estimate.covariance);
  std::copy(covariance.begin(), covariance.end(), state.pose.covariance.begin());
  state.load = wrenchMsg(estimate.load);
  state.cables = toMsg(estimate.solution.cables);
  state.length_residual = estimate.length_residual;
  const auto is_there = [](const std::optional<double>& tension) { return tension.has_value(); };
  if (std::any_of(measured.tensions.begin(), measured.tensions.end(), is_there)) {
    state.tension_residual = estimate.tension_residual;
  }
  for (std::size_t i = 0; i < estimate.length_outlier.size(); ++i) {
    const bool left_out = estimate.length_outlier[i] || estimate.tension_outlier[i];
    state.outlier.push_back(left_out || estimate.length_suspect[i] || estimate.tension_suspect[i]);
  }
  return state;
}

}  // namespace

KinetostaticState toMsg(const Estimate& estimate, const Measurement& measurement, const RobotDescription& robot,
                        const std::string& base_frame) {
  KinetostaticState state = withoutPose(robot);
  state.report = toMsg(estimate.solution.report);
  if (estimate.solution.report.status.ok()) state = fromEstimate(estimate, measurement.cables);
  if (!isFinite(state)) {
    state = withoutPose(robot);
    state.report = failure(Code::kInternalError, "the estimate has a number that is not finite; please report this");
  }
  state.header = measurement.header;
  state.header.frame_id = base_frame;
  return state;
}

geometry_msgs::PoseWithCovarianceStamped poseOf(const KinetostaticState& state) {
  geometry_msgs::PoseWithCovarianceStamped pose;
  pose.header = state.header;
  pose.pose = state.pose;
  return pose;
}

geometry_msgs::WrenchStamped loadOf(const KinetostaticState& state) {
  geometry_msgs::WrenchStamped load;
  load.header = state.header;
  load.wrench = state.load;
  return load;
}

geometry_msgs::TransformStamped transformOf(const KinetostaticState& state, const std::string& platform_frame) {
  geometry_msgs::TransformStamped transform;
  transform.header = state.header;
  transform.child_frame_id = platform_frame;
  transform.transform.translation.x = state.pose.pose.position.x;
  transform.transform.translation.y = state.pose.pose.position.y;
  transform.transform.translation.z = state.pose.pose.position.z;
  transform.transform.rotation = state.pose.pose.orientation;
  return transform;
}

}  // namespace cdpr_kinetostatics

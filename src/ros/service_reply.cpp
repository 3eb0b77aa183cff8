#include "ros/service_reply.h"

#include <algorithm>
#include <cmath>

#include "ros/conversions.h"

namespace cdpr_kinetostatics {

bool allFinite(double value) { return std::isfinite(value); }

bool allFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

bool allFinite(const SolveReport& report) {
  return allFinite({report.solve_time, report.closure_residual, report.force_residual, report.moment_residual,
                    report.estimated_error, report.estimated_rotation_error});
}

bool allFinite(const geometry_msgs::Pose& pose) {
  return allFinite({pose.position.x, pose.position.y, pose.position.z, pose.orientation.x, pose.orientation.y,
                    pose.orientation.z, pose.orientation.w});
}

bool allFinite(const CableState& state) {
  const auto& force = state.force_on_platform;
  const bool numbers =
      allFinite({state.length, state.strained_length, state.tension_a, state.tension_b, state.horizontal_force,
                 state.vertical_force_a, state.angle_a, state.angle_b, force.x, force.y, force.z, state.sag,
                 state.max_moment, state.max_shear, state.estimated_error});
  const auto finite_point = [](const geometry_msgs::Point& point) { return allFinite({point.x, point.y, point.z}); };
  return numbers && allFinite(state.wrap_angle) && finite_point(state.departure) &&
         std::all_of(state.profile.begin(), state.profile.end(), finite_point);
}

bool allFinite(const std::vector<CableState>& states) {
  return std::all_of(states.begin(), states.end(), [](const CableState& state) { return allFinite(state); });
}

SolveReport failure(Code code, const std::string& message) {
  Status status;
  status.code = code;
  status.message = message;
  return toMsg(status);
}

}  // namespace cdpr_kinetostatics

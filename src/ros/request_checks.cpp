#include "ros/request_checks.h"

#include <algorithm>

#include "cable/text.h"
#include "robot/robot_checks.h"
#include "ros/conversions.h"

namespace cdpr_kinetostatics {

namespace {

// Messages' quaternions this near to unit length are taken as rounded, and normalised [-].
constexpr double kRoundedUnitNorm = 1e-3;

std::size_t indexOf(const std::string& name, const std::string& where, const RobotDescription& robot) {
  const auto same_name = [&](const CableDescription& cable) { return cable.name == name; };
  const auto found = std::find_if(robot.cables.begin(), robot.cables.end(), same_name);
  if (found == robot.cables.end()) {
    throw RequestError(
        text(where, " is '", name, "', which ", robot.name, " does not have: its cables are ", namesOfCables(robot)),
        Code::kUnknownCable);
  }
  return static_cast<std::size_t>(found - robot.cables.begin());
}

// The index of each named cable.
std::vector<std::size_t> distinctCables(const std::vector<std::string>& names, const RobotDescription& robot) {
  std::vector<std::size_t> cables;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t cable = indexOf(names[i], text("cable_names[", i, "]"), robot);
    if (std::find(cables.begin(), cables.end(), cable) != cables.end()) {
      throw RequestError(text("cable_names[", i, "] is '", names[i], "' once more: expected each cable once"));
    }
    cables.push_back(cable);
  }
  return cables;
}

Model checkedModel(std::uint8_t asked, Model node_default) {
  if (asked > SolverOptions::BENDING) {
    throw RequestError(
        text("options.model is ", int{asked}, ": expected one of the constants of SolverOptions, 0 to 8"));
  }
  return asked == SolverOptions::MODEL_DEFAULT ? node_default : static_cast<Model>(asked);
}

double checkedTimeout(double asked, double node_default) {
  if (!(asked >= 0.0 && asked <= kLongestTimeout)) {
    throw RequestError(text("options.timeout is ", asked, " s: expected up to ", kLongestTimeout,
                            " s, or 0 for the node's ", node_default, " s"));
  }
  return asked > 0.0 ? asked : node_default;
}

}  // namespace

void require(const Status& status, const std::string& otherwise) {
  if (!status.ok()) throw RequestError(status.message + otherwise, status.code);
}

Pose checkedPose(const std::string& field, const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  Pose unnormalised = fromMsg(pose);
  unnormalised.orientation = Eigen::Quaterniond(q.w, q.x, q.y, q.z);
  require(checkPose(field, unnormalised, kRoundedUnitNorm));
  return fromMsg(pose);
}

std::vector<double> orderedLengths(const std::vector<double>& lengths, const std::vector<std::string>& names,
                                   const RobotDescription& robot) {
  if (names.empty()) return lengths;
  if (names.size() != lengths.size()) {
    throw RequestError(text("cable_names has ", names.size(), " entries and lengths has ", lengths.size(),
                            ": expected one name for each length, or no names for the robot's order"));
  }
  const std::vector<std::size_t> cables = distinctCables(names, robot);
  require(checkCount("lengths", lengths.size(), robot));
  std::vector<double> ordered(lengths.size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    // The core would name the place in the robot's order, not in the message.
    require(checkLength({"lengths", i, names[i]}, lengths[i]));
    ordered[cables[i]] = lengths[i];
  }
  return ordered;
}

const CableDescription& findCable(const std::string& name, const RobotDescription& robot) {
  return robot.cables[indexOf(name, "cable_name", robot)];
}

RobotSolverOptions checkedOptions(const SolverOptions& options, int profile_points, const NodeParameters& parameters) {
  RobotSolverOptions checked;
  checked.model = checkedModel(options.model, parameters.model);
  checked.accuracy = options.accuracy != 0.0 ? options.accuracy : parameters.accuracy;
  checked.tolerance = options.tolerance != 0.0 ? options.tolerance : parameters.tolerance;
  checked.timeout = std::chrono::duration<double>(checkedTimeout(options.timeout.toSec(), parameters.timeout));
  checked.profile_points = profile_points;
  require(checkAccuracy("options.accuracy", checked.accuracy), text(", or 0 for the node's ", parameters.accuracy));
  require(checkTolerance("options.tolerance", checked.tolerance), text(", or 0 for the node's ", parameters.tolerance));
  require(checkProfilePoints("profile_points", profile_points, kMostMessagePoints));
  return checked;
}

}  // namespace cdpr_kinetostatics

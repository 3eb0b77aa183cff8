#include "ros/request_checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ros/text.h"

namespace cdpr_kinetostatics {

namespace {

constexpr double kQuaternionTolerance = 1e-3;

std::string namesOf(const RobotDescription& robot) {
  std::string names;
  for (const CableDescription& cable : robot.cables) names += (names.empty() ? "" : ", ") + cable.name;
  return names;
}

std::string cableField(const char* field, std::size_t index, const std::string& name) {
  return text(field, "[", index, "] (", name, ")");
}

std::size_t indexOf(const std::string& name, const std::string& where, const RobotDescription& robot) {
  const auto same_name = [&](const CableDescription& cable) { return cable.name == name; };
  const auto found = std::find_if(robot.cables.begin(), robot.cables.end(), same_name);
  if (found == robot.cables.end()) {
    throw RequestError(
        text(where, " is '", name, "', which ", robot.name, " does not have: its cables are ", namesOf(robot)),
        Code::kUnknownCable);
  }
  return static_cast<std::size_t>(found - robot.cables.begin());
}

std::vector<std::size_t> inOrder(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
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

void checkProfilePoints(int points) {
  if (points == 0 || (points >= 2 && points <= kMaxProfilePoints)) return;
  throw RequestError(text("profile_points is ", points, ": expected 0 (no profile) or 2 to ", kMaxProfilePoints));
}

}  // namespace

void checkWithin(const std::string& where, double value, double limit, const char* unit) {
  if (std::abs(value) <= limit) return;
  throw RequestError(
      text(where, " is ", value, " ", unit, ": expected a finite number of magnitude up to ", limit, " ", unit));
}

void checkNotNegative(const std::string& where, double value, double limit, const char* unit) {
  if (value >= 0.0 && value <= limit) return;
  throw RequestError(text(where, " is ", value, " ", unit, ": expected 0 to ", limit, " ", unit));
}

void checkPositive(const std::string& where, double value, double limit, const char* unit) {
  if (value > 0.0 && value <= limit) return;
  throw RequestError(text(where, " is ", value, " ", unit, ": expected a positive number up to ", limit, " ", unit));
}

void checkPose(const std::string& where, const geometry_msgs::Pose& pose) {
  checkWithin(where + ".position.x", pose.position.x, kMaxLength, "m");
  checkWithin(where + ".position.y", pose.position.y, kMaxLength, "m");
  checkWithin(where + ".position.z", pose.position.z, kMaxLength, "m");
  const auto& q = pose.orientation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (std::abs(norm - 1.0) <= kQuaternionTolerance) return;
  throw RequestError(text(where, ".orientation (x, y, z, w) is (", q.x, ", ", q.y, ", ", q.z, ", ", q.w, ") of norm ",
                          norm, ": expected a unit quaternion, norm within ", kQuaternionTolerance,
                          " of 1; no rotation is (0, 0, 0, 1)"));
}

void checkWrench(const std::string& where, const geometry_msgs::Wrench& wrench, PlatformType type) {
  checkWithin(where + ".force.x", wrench.force.x, kMaxForce, "N");
  checkWithin(where + ".force.y", wrench.force.y, kMaxForce, "N");
  checkWithin(where + ".force.z", wrench.force.z, kMaxForce, "N");
  checkWithin(where + ".torque.x", wrench.torque.x, kMaxForce, "N m");
  checkWithin(where + ".torque.y", wrench.torque.y, kMaxForce, "N m");
  checkWithin(where + ".torque.z", wrench.torque.z, kMaxForce, "N m");
  const auto& torque = wrench.torque;
  const bool has_torque = torque.x != 0.0 || torque.y != 0.0 || torque.z != 0.0;
  if (type != PlatformType::kPointMass || !has_torque) return;
  throw RequestError(text(where, ".torque is (", torque.x, ", ", torque.y, ", ", torque.z,
                          ") N m: the platform is a point mass, which takes no torque; set it to 0"));
}

std::vector<double> orderedLengths(const std::vector<double>& lengths, const std::vector<std::string>& names,
                                   const RobotDescription& robot) {
  const std::size_t count = robot.cables.size();
  if (!names.empty() && names.size() != lengths.size()) {
    throw RequestError(text("cable_names has ", names.size(), " entries and lengths has ", lengths.size(),
                            ": expected one name for each length, or no names for the robot's order"));
  }
  const std::vector<std::size_t> cables = names.empty() ? inOrder(lengths.size()) : distinctCables(names, robot);
  if (lengths.size() != count) {
    throw RequestError(text("lengths has ", lengths.size(), " entries: ", robot.name, " needs ", count,
                            ", one for each of ", namesOf(robot)));
  }
  std::vector<double> ordered(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    checkPositive(cableField("lengths", i, robot.cables[cables[i]].name), lengths[i], kMaxLength, "m");
    ordered[cables[i]] = lengths[i];
  }
  return ordered;
}

void checkPreferredTensions(const std::vector<double>& tensions, const RobotDescription& robot) {
  if (tensions.empty()) return;
  if (tensions.size() != robot.cables.size()) {
    throw RequestError(text("preferred_tensions has ", tensions.size(), " entries: expected ", robot.cables.size(),
                            ", one for each of ", namesOf(robot), ", or none for the middle of the limits"));
  }
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    checkNotNegative(cableField("preferred_tensions", i, robot.cables[i].name), tensions[i], kMaxForce, "N");
  }
}

const CableDescription& findCable(const std::string& name, const RobotDescription& robot) {
  return robot.cables[indexOf(name, "cable_name", robot)];
}

RobotSolverOptions checkedOptions(const SolverOptions& options, int profile_points, const NodeParameters& parameters) {
  RobotSolverOptions checked;
  checked.model = checkedModel(options.model, parameters.model);
  checkNotNegative("options.accuracy", options.accuracy, kMaxLength, "m");
  checked.accuracy = options.accuracy > 0.0 ? options.accuracy : parameters.accuracy;
  checked.tolerance = parameters.tolerance;
  if (options.tolerance != 0.0) {
    if (!(options.tolerance >= kMinTolerance && options.tolerance <= kMaxTolerance)) {
      throw RequestError(text("options.tolerance is ", options.tolerance, ": expected ", kMinTolerance, " to ",
                              kMaxTolerance, ", or 0 for the node's ", parameters.tolerance));
    }
    checked.tolerance = options.tolerance;
  }
  const double timeout = options.timeout.toSec();
  if (!(timeout >= 0.0 && timeout <= kMaxTimeout)) {
    throw RequestError(text("options.timeout is ", timeout, " s: expected up to ", kMaxTimeout,
                            " s, or 0 for the node's ", parameters.timeout, " s"));
  }
  checked.timeout = std::chrono::duration<double>(timeout > 0.0 ? timeout : parameters.timeout);
  checkProfilePoints(profile_points);
  checked.profile_points = profile_points;
  return checked;
}

}  // namespace cdpr_kinetostatics

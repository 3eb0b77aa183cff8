#include "robot/robot_checks.h"

#include <cmath>

#include "cable/text.h"

namespace cdpr_kinetostatics {
namespace {

const Status kFine{Code::kConverged, ""};

Status checkPoint(const char* field, const Eigen::Vector3d& point) {
  for (const double coordinate : point) {
    const Status status = checkWithin(field, coordinate, kLargestLength, "m");
    if (!status.ok()) return status;
  }
  return kFine;
}

// What a unit of a drive's position is worth [m]: the finest is a count of an encoder of many turns, the largest is far
// above any drum's turn.
constexpr double kLeastScale = 1e-12;
constexpr double kLargestScale = 1e6;

Status checkDescription(const CableDescription& cable) {
  return firstRefusal(checkPoint("anchor", cable.anchor), checkPoint("attachment", cable.attachment),
                      checkCable(cable.properties, Model::kBending),
                      checkNotNegative("tension_min", cable.tension_min, kLargestForce, "N"),
                      checkNotNegative("tension_max", cable.tension_max, kLargestForce, "N"),
                      checkBetween("the magnitude of scale", std::abs(cable.scale), kLeastScale, kLargestScale,
                                   "m per unit of position"),
                      checkWithin("offset", cable.offset, kLargestLength, "m"));
}

// The tensions, pitch and roll are to meet six equations.
constexpr std::size_t kLeastCablesToHoldYaw = 4;

}  // namespace

std::string namesOfCables(const RobotDescription& robot) {
  std::string names;
  for (const CableDescription& cable : robot.cables) names += (names.empty() ? "" : ", ") + cable.name;
  return names;
}

Status checkRobot(const RobotDescription& robot) {
  Status status = firstRefusal(
      checkBetween("mass", robot.mass, kLeastWeight / kLargestGravity, kLargestForce, "kg"),
      checkBetween("gravity", robot.gravity, kLeastGravity, kLargestGravity, "m/s^2"),
      checkBetween("the platform's weight, mass times gravity,", robot.weight(), kLeastWeight, kLargestForce, "N"),
      checkPoint("com", robot.com));
  if (status.ok() && (robot.cables.empty() || robot.cables.size() > kMostCables)) {
    status = refused("the number of cables", text(robot.cables.size()), text("1 to ", kMostCables));
  }
  for (const CableDescription& cable : robot.cables) {
    if (!status.ok()) break;
    status = checkDescription(cable);
    if (!status.ok()) status.message = "cable '" + cable.name + "': " + status.message;
  }
  return status;
}

Status checkRobotOptions(const RobotSolverOptions& options) {
  return firstRefusal(checkTolerance("tolerance", options.tolerance), checkAccuracy("accuracy", options.accuracy),
                      checkProfilePoints("profile_points", options.profile_points), checkModel(options.model));
}

Status checkPose(std::string_view field, const Pose& pose, double unit_norm) {
  Status status = firstRefusal(checkWithin({field, ".position.x"}, pose.position.x(), kLargestLength, "m"),
                               checkWithin({field, ".position.y"}, pose.position.y(), kLargestLength, "m"),
                               checkWithin({field, ".position.z"}, pose.position.z(), kLargestLength, "m"));
  const Eigen::Quaterniond& q = pose.orientation;
  if (!status.ok() || std::abs(q.norm() - 1.0) <= unit_norm) return status;
  return refused({field, ".orientation (x, y, z, w)"},
                 text("(", q.x(), ", ", q.y(), ", ", q.z(), ", ", q.w(), ") of norm ", q.norm()),
                 text("a unit quaternion, norm within ", unit_norm, " of 1; no rotation is (0, 0, 0, 1)"));
}

Status checkWrench(const RobotDescription& robot, const Wrench& external) {
  static constexpr const char* kMembers[6] = {".force.x",  ".force.y",  ".force.z",
                                              ".torque.x", ".torque.y", ".torque.z"};
  for (Eigen::Index k = 0; k < 6; ++k) {
    const Status status =
        checkWithin({"external_wrench", kMembers[k]}, external(k), kLargestForce, k < 3 ? "N" : "N m");
    if (!status.ok()) return status;
  }
  if (robot.type != PlatformType::kPointMass || external.tail<3>().isZero(0.0)) return kFine;
  return refused("external_wrench.torque", text("(", external(3), ", ", external(4), ", ", external(5), ") N m"),
                 "0, as the platform is a point mass, which takes no torque");
}

Status checkCount(const Field& field, std::size_t count, const RobotDescription& robot, const std::string& otherwise) {
  if (count == robot.cables.size()) return kFine;
  return {Code::kInvalidInput, text(field.text(), " has ", count, " entries: expected ", robot.cables.size(),
                                    ", one for each of ", namesOfCables(robot), otherwise)};
}

Status checkLengths(const RobotDescription& robot, const std::vector<double>& lengths) {
  Status status = checkCount("lengths", lengths.size(), robot);
  for (std::size_t i = 0; status.ok() && i < lengths.size(); ++i) {
    status = checkLength({"lengths", i, robot.cables[i].name}, lengths[i]);
  }
  return status;
}

Status checkPreferredTensions(const RobotDescription& robot, const std::vector<double>& tensions) {
  if (tensions.empty()) return kFine;
  Status status = checkCount("preferred_tensions", tensions.size(), robot, ", or none for the middle of the limits");
  for (std::size_t i = 0; status.ok() && i < tensions.size(); ++i) {
    status = checkNotNegative({"preferred_tensions", i, robot.cables[i].name}, tensions[i], kLargestForce, "N");
  }
  return status;
}

Status checkHoldYaw(const RobotDescription& robot, bool hold_yaw) {
  if (!hold_yaw || robot.cables.size() >= kLeastCablesToHoldYaw) return kFine;
  return refused("hold_yaw", "true",
                 text("false for ", robot.name, ", which has ", robot.cables.size(), " cables: fewer than ",
                      kLeastCablesToHoldYaw, " cannot hold a heading besides a position"));
}

}  // namespace cdpr_kinetostatics

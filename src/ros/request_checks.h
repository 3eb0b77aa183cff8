// Checks of what users ask for, before anything is computed.
//
// Each check throws RequestError, whose sentence names the field, its value and what to do.
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Wrench.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/SolverOptions.h"
#include "cdpr_kinetostatics/cable/report.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "ros/parameters.h"

namespace cdpr_kinetostatics {

class RequestError : public std::runtime_error {
 public:
  explicit RequestError(const std::string& message, Code code = Code::kInvalidInput)
      : std::runtime_error(message), code_(code) {}

  Code code() const { return code_; }

 private:
  Code code_;
};

// Beyond these a number is a mistake of units or an overflow; the solvers are tested up to them.
constexpr double kMaxLength = 1e6;      // lengths and coordinates [m]
constexpr double kMaxForce = 1e12;      // forces [N], torques [N m], stiffnesses [N, N m^2]
constexpr double kMaxDensity = 1e6;     // [kg/m]
constexpr double kMinAccuracy = 1e-15;  // [m]
constexpr double kMinTolerance = 1e-13;
constexpr double kMaxTolerance = 0.1;
constexpr double kMinTimeout = 1e-4;    // [s]
constexpr double kMaxTimeout = 3600.0;  // [s]
constexpr int kMaxProfilePoints = 10000;

// |value| <= limit, finite; `where` names the field, as in "external_wrench.force.x".
void checkWithin(const std::string& where, double value, double limit, const char* unit);
void checkNotNegative(const std::string& where, double value, double limit, const char* unit);
void checkPositive(const std::string& where, double value, double limit, const char* unit);

void checkPose(const std::string& where, const geometry_msgs::Pose& pose);
void checkWrench(const std::string& where, const geometry_msgs::Wrench& wrench, PlatformType type);

// The lengths in the robot's order. Empty names: they are in that order already.
std::vector<double> orderedLengths(const std::vector<double>& lengths, const std::vector<std::string>& names,
                                   const RobotDescription& robot);

void checkPreferredTensions(const std::vector<double>& tensions, const RobotDescription& robot);

// The cable of that name; UNKNOWN_CABLE if there is none.
const CableDescription& findCable(const std::string& name, const RobotDescription& robot);

// The options to solve with: zeros replaced by the node's parameters.
RobotSolverOptions checkedOptions(const SolverOptions& options, int profile_points, const NodeParameters& parameters);

}  // namespace cdpr_kinetostatics

// Checks of what only messages have: names of cables, a quaternion that is nearly unit, zeros that stand for the node's
// parameters. What the core asks of a problem it checks itself (robot/robot_checks.h, cable/cable_checks.h), under the
// fields' names in the messages.
#pragma once

#include <geometry_msgs/Pose.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/SolverOptions.h"
#include "cdpr_kinetostatics/cable/report.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"
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

// Throws what one of the core's checks refuses; `otherwise` ends its sentence.
void require(const Status& status, const std::string& otherwise = "");

// The pose with a unit quaternion; it need only be nearly so. `field` is the pose's name.
Pose checkedPose(const std::string& field, const geometry_msgs::Pose& pose);

// The lengths in the robot's order. Empty names: they are in that order already.
std::vector<double> orderedLengths(const std::vector<double>& lengths, const std::vector<std::string>& names,
                                   const RobotDescription& robot);

// The cable of that name; UNKNOWN_CABLE if there is none.
const CableDescription& findCable(const std::string& name, const RobotDescription& robot);

// The options to solve with: zeros replaced by the node's parameters.
RobotSolverOptions checkedOptions(const SolverOptions& options, int profile_points, const NodeParameters& parameters);

}  // namespace cdpr_kinetostatics

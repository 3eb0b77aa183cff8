// All conversions between ROS types and the core's types. They do not check what they convert: request_checks.h does.
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>
#include <geometry_msgs/Wrench.h>
#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/CableState.h"
#include "cdpr_kinetostatics/SolveReport.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"

namespace XmlRpc {
class XmlRpcValue;
}

namespace cdpr_kinetostatics {

// A parameter as the YAML that it was loaded from, for parseRobot. Throws std::invalid_argument for types
// that a robot description cannot hold (date, binary).
YAML::Node toYaml(const XmlRpc::XmlRpcValue& value);

// The quaternion is normalised. It must not be zero: checkedPose() in request_checks.h refuses that.
Pose fromMsg(const geometry_msgs::Pose& pose);
Wrench fromMsg(const geometry_msgs::Wrench& wrench);

geometry_msgs::Pose toMsg(const Pose& pose);
geometry_msgs::Point toPoint(const Eigen::Vector3d& point);
geometry_msgs::Vector3 toVector3(const Eigen::Vector3d& vector);

SolveReport toMsg(const RobotReport& report);
SolveReport toMsg(const Status& status);

// A cable of the robot, in the world.
CableState toMsg(const CableResult& result);
std::vector<CableState> toMsg(const std::vector<CableResult>& results);

// A cable alone, in its plane: (x, 0, y).
CableState toMsg(const CableSolution& solution, const std::string& name, Condition condition);

// The 36 numbers of the matrix, row by row.
std::vector<double> toMsg(const Eigen::Matrix<double, 6, 6>& matrix);

}  // namespace cdpr_kinetostatics

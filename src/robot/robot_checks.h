// What a robot's problem must satisfy before it is solved; sentences as in cable/cable_checks.h. Fields have the names
// of ForwardRequest, InverseRequest and RobotSolverOptions, which are those of the services' messages.
#pragma once

#include <string_view>
#include <vector>

#include "cable/cable_checks.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

// What is described must be a robot: numbers within the limits of cable/input_limits.h, at least one cable. Readers of
// files refuse earlier and say more; robots that are built in C++ have nothing but this.
Status checkRobot(const RobotDescription& robot);

Status checkRobotOptions(const RobotSolverOptions& options);

// The quaternion's norm may differ from 1 by so much.
Status checkPose(std::string_view field, const Pose& pose, double unit_norm = kUnitNorm);
Status checkWrench(const RobotDescription& robot, const Wrench& external);

// As many entries as the robot has cables; `otherwise` ends the sentence of one that has not.
Status checkCount(const Field& field, std::size_t count, const RobotDescription& robot,
                  const std::string& otherwise = "");
Status checkLengths(const RobotDescription& robot, const std::vector<double>& lengths);
// One for each cable, or none.
Status checkPreferredTensions(const RobotDescription& robot, const std::vector<double>& tensions);

// Whether a heading can be held with the attitude free.
Status checkHoldYaw(const RobotDescription& robot, bool hold_yaw);

// "cable0, cable1": for messages.
std::string namesOfCables(const RobotDescription& robot);

}  // namespace cdpr_kinetostatics

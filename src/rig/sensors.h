// What the rig's sensors say of true lengths and tensions: noise, bias, steps, and faults, the same for the same seed.
// Drives report positions; what is wrong with a length is in metres.
#pragma once

#include <sensor_msgs/JointState.h>

#include <optional>
#include <random>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "rig/parameters.h"
#include "rig/truth.h"

namespace cdpr_kinetostatics {

class RigMeasurements {
 public:
  // Both must outlive this.
  RigMeasurements(const RobotDescription& robot, const RigSensors& sensors);

  // The message without its stamp; nothing if it drops out. NaN stands for what a faulty sensor does not give.
  std::optional<sensor_msgs::JointState> measure(const RigTruth& truth, double time);

 private:
  void applyFaults(double time, sensor_msgs::JointState* message);

  const RobotDescription& robot_;
  const RigSensors& sensors_;
  std::mt19937_64 random_;
  std::vector<double> offset_errors_;         // per cable [m]
  std::vector<std::optional<double>> stuck_;  // per fault
};

}  // namespace cdpr_kinetostatics

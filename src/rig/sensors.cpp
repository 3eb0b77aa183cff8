#include "rig/sensors.h"

#include <cmath>
#include <limits>

namespace cdpr_kinetostatics {

namespace {

double rounded(double value, double resolution) {
  return resolution > 0.0 ? resolution * std::round(value / resolution) : value;
}

}  // namespace

RigMeasurements::RigMeasurements(const RobotDescription& robot, const RigSensors& sensors)
    : robot_(robot),
      sensors_(sensors),
      random_(static_cast<std::uint64_t>(sensors.seed)),
      stuck_(sensors.faults.size()) {
  // Numbers of their own, so that offsets leave all others as they were.
  std::mt19937_64 random(~static_cast<std::uint64_t>(sensors.seed));
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) offset_errors_.push_back(sensors.offset_error * normal(random));
}

std::optional<sensor_msgs::JointState> RigMeasurements::measure(const RigTruth& truth, double time) {
  // The number of draws is the same in each step, so that switching a fault on leaves all other numbers as they were.
  std::normal_distribution<double> normal;
  sensor_msgs::JointState message;
  const bool lost = std::uniform_real_distribution<double>()(random_) < sensors_.dropout;
  for (std::size_t i = 0; i < truth.lengths.size(); ++i) {
    const double length =
        truth.lengths[i] + sensors_.length_bias + offset_errors_[i] + sensors_.length_noise * normal(random_);
    const double tension = truth.tensions[i] + sensors_.tension_bias + sensors_.tension_noise * normal(random_);
    message.name.push_back(robot_.cables[i].name);
    message.position.push_back(robot_.cables[i].positionAt(rounded(length, sensors_.length_resolution)));
    if (sensors_.tensions) message.effort.push_back(rounded(tension, sensors_.tension_resolution));
  }
  applyFaults(time, &message);
  if (lost) return std::nullopt;
  return message;
}

void RigMeasurements::applyFaults(double time, sensor_msgs::JointState* message) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < sensors_.faults.size(); ++k) {
    const RigFault& fault = sensors_.faults[k];
    if (time < fault.start || time > fault.end) continue;
    double& length = message->position[fault.cable];
    double unused = 0.0;
    double& tension = sensors_.tensions ? message->effort[fault.cable] : unused;
    switch (fault.kind) {
      case RigFault::Kind::kStuckTension:
        if (!stuck_[k]) stuck_[k] = fault.value > 0.0 ? fault.value : tension;
        tension = *stuck_[k];
        break;
      case RigFault::Kind::kTensionBias:
        tension += fault.value;
        break;
      case RigFault::Kind::kLengthOffset:
        length += fault.value / robot_.cables[fault.cable].scale;
        break;
      case RigFault::Kind::kNoLength:
        length = kNothing;
        break;
      case RigFault::Kind::kNoTension:
        tension = kNothing;
        break;
    }
  }
}

}  // namespace cdpr_kinetostatics

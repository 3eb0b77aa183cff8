// What arrives on cable_states: checked, put in the robot's order, and counted.
//
// Every message is either used, or refused and counted with the reason. A number that is missing (NaN, no entry for
// that cable, no effort) or cannot be (a length that is not positive) leaves that measurement out, not the message.
//
// Drives report positions in units of their own: lengths are scale * position + offset.
#pragma once

#include <ros/time.h>
#include <sensor_msgs/JointState.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

struct InputCounts {
  std::uint64_t received = 0;
  std::uint64_t accepted = 0;
  // Refused messages.
  std::uint64_t malformed = 0;  // wrong sizes, no or repeated names, none of the robot's cables
  std::uint64_t stale = 0;      // older than ~max_age when it arrived, or as far in the future
  std::uint64_t repeated = 0;   // same stamp as the last one
  std::uint64_t reordered = 0;  // earlier than the last one by less than ~max_age
  // Found in messages that were accepted.
  std::uint64_t time_jumps = 0;     // time went backwards: the estimator was reset
  std::uint64_t unknown_names = 0;  // entries that are none of the robot's cables
  std::uint64_t missing_lengths = 0;
  std::uint64_t missing_tensions = 0;
  std::uint64_t impossible = 0;  // measurements that cannot be: length <= 0, beyond limits

  std::uint64_t refused() const { return malformed + stale + repeated + reordered; }
};

struct Measurement {
  std_msgs::Header header;
  CableMeasurements cables;
  bool reset_first = false;  // time went backwards: the estimator must forget what it knows
};

class MeasurementInput {
 public:
  // The robot must outlive the input.
  MeasurementInput(const RobotDescription& robot, double max_age);

  // The measurement, or nothing if the message is refused.
  std::optional<Measurement> check(const sensor_msgs::JointState& message, const ros::Time& now);

  // What a drive's position of 0 means, in the robot's order [m]: at first the robot's, later what homing finds.
  const std::vector<double>& offsets() const { return offsets_; }
  void setOffsets(const std::vector<double>& offsets) { offsets_ = offsets; }

  // Forgets the stamps of earlier messages, but not the counts.
  void reset();

  const InputCounts& counts() const { return counts_; }
  // Of the last message that was refused, or had something missing; empty if there was none.
  const std::string& lastProblem() const { return last_problem_; }

 private:
  struct Problem;
  struct Problems;

  bool refuse(std::uint64_t* count, const std::string& problem);
  bool hasRightShape(const sensor_msgs::JointState& message);
  bool hasRightTime(const ros::Time& stamp, const ros::Time& now, bool* jumped);
  void readCables(const sensor_msgs::JointState& message, CableMeasurements* cables);
  // The value if it passed the check.
  std::optional<double> read(double value, const Status& check, Problems* problems);

  const RobotDescription& robot_;
  const double max_age_;  // [s]
  std::vector<double> offsets_;
  InputCounts counts_;
  std::string last_problem_;
  ros::Time last_stamp_, last_now_;
  bool clock_went_back_ = false;  // since the last message that was accepted
};

}  // namespace cdpr_kinetostatics

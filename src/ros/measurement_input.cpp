#include "ros/measurement_input.h"

#include <algorithm>
#include <cmath>

#include "cable/cable_checks.h"
#include "cable/text.h"
#include "ros/clock_watch.h"

namespace cdpr_kinetostatics {

namespace {

// [s]. A ros::Duration holds no more than 68 years and throws beyond: a stamp can be anything.
double secondsBetween(const ros::Time& from, const ros::Time& to) { return to.toSec() - from.toSec(); }

}  // namespace

// What is wrong with a message that is used all the same, of one kind: the first in words, the others counted.
struct MeasurementInput::Problem {
  std::string first;
  int count = 0;

  void add(const std::string& sentence) {
    if (count++ == 0) first = sentence;
  }
  std::string sentence() const { return count == 1 ? first : text(first, "; and ", count - 1, " more like this"); }
};

// A measurement that cannot be is missing, too, but why it is says more.
struct MeasurementInput::Problems {
  Problem impossible, missing, unknown;

  const Problem* worst() const {
    for (const Problem* problem : {&impossible, &missing, &unknown}) {
      if (problem->count > 0) return problem;
    }
    return nullptr;
  }
};

MeasurementInput::MeasurementInput(const RobotDescription& robot, double max_age) : robot_(robot), max_age_(max_age) {
  for (const CableDescription& cable : robot.cables) offsets_.push_back(cable.offset);
}

void MeasurementInput::reset() {
  last_stamp_ = last_now_ = ros::Time();
  clock_went_back_ = false;
}

bool MeasurementInput::refuse(std::uint64_t* count, const std::string& problem) {
  ++*count;
  last_problem_ = problem;
  return false;
}

bool MeasurementInput::hasRightShape(const sensor_msgs::JointState& message) {
  const std::size_t names = message.name.size();
  if (names == 0) {
    return refuse(&counts_.malformed, "name is empty: expected the names of the cables");
  }
  if (message.position.size() != names) {
    return refuse(&counts_.malformed,
                  text("position has ", message.position.size(), " entries for ", names, " names: expected one each"));
  }
  if (!message.effort.empty() && message.effort.size() != names) {
    return refuse(&counts_.malformed, text("effort has ", message.effort.size(), " entries for ", names,
                                           " names: expected one each, or none if tensions are not measured"));
  }
  std::vector<std::string> sorted = message.name;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    return refuse(&counts_.malformed, text("name has '", *twice, "' more than once: expected each cable once"));
  }
  const auto known = [&](const CableDescription& cable) {
    return std::binary_search(sorted.begin(), sorted.end(), cable.name);
  };
  if (std::none_of(robot_.cables.begin(), robot_.cables.end(), known)) {
    return refuse(&counts_.malformed, text("none of the names is a cable of ", robot_.name, ": the first is '",
                                           message.name[0], "', the robot's first '", robot_.cables[0].name, "'"));
  }
  return true;
}

bool MeasurementInput::hasRightTime(const ros::Time& stamp, const ros::Time& now, bool* jumped) {
  clock_went_back_ |= now < last_now_;
  last_now_ = now;
  if (now.isZero()) {
    return refuse(&counts_.stale, kNoTime);
  }
  if (stamp.isZero()) return refuse(&counts_.stale, "header.stamp is 0: expected the time of the measurement");
  const double age = secondsBetween(stamp, now);
  if (std::abs(age) > max_age_) {
    return refuse(&counts_.stale, text("stamped ", std::abs(age), age > 0.0 ? " s ago" : " s in the future",
                                       ": expected within max_age of ", max_age_,
                                       " s; are the clocks of the machines the same? Is use_sim_time set for a bag?"));
  }
  const double back = secondsBetween(stamp, last_stamp_);
  *jumped = !last_stamp_.isZero() && stamp < last_stamp_ && (clock_went_back_ || back > max_age_);
  if (*jumped || last_stamp_.isZero() || stamp > last_stamp_) return true;
  if (stamp == last_stamp_) return refuse(&counts_.repeated, "the same stamp as the message before");
  return refuse(&counts_.reordered, text("stamped ", back, " s before the message before"));
}

void MeasurementInput::readCables(const sensor_msgs::JointState& message, CableMeasurements* cables) {
  cables->lengths.assign(robot_.cables.size(), std::nullopt);
  cables->tensions.assign(robot_.cables.size(), std::nullopt);
  Problems problems;
  for (std::size_t k = 0; k < message.name.size(); ++k) {
    const auto same_name = [&](const CableDescription& cable) { return cable.name == message.name[k]; };
    const auto found = std::find_if(robot_.cables.begin(), robot_.cables.end(), same_name);
    if (found == robot_.cables.end()) {
      ++counts_.unknown_names;
      problems.unknown.add(text("'", message.name[k], "' is not a cable of ", robot_.name));
      continue;
    }
    const auto i = static_cast<std::size_t>(found - robot_.cables.begin());
    const double length = found->scale * message.position[k] + offsets_[i];
    cables->lengths[i] = read(length, checkLength({"position", k, found->name}, length), &problems);
    if (message.effort.empty()) continue;
    const double tension = message.effort[k];
    cables->tensions[i] =
        read(tension, checkWithin({"effort", k, found->name}, tension, kLargestForce, "N"), &problems);
  }
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    if (!cables->lengths[i]) {
      ++counts_.missing_lengths;
      problems.missing.add(text("no length of ", robot_.cables[i].name));
    }
    if (!cables->tensions[i] && !message.effort.empty()) {
      ++counts_.missing_tensions;
      problems.missing.add(text("no tension of ", robot_.cables[i].name));
    }
  }
  if (const Problem* worst = problems.worst()) last_problem_ = worst->sentence();
}

std::optional<double> MeasurementInput::read(double value, const Status& check, Problems* problems) {
  if (check.ok()) return value;
  if (!std::isnan(value)) {  // which stands for a measurement that is missing
    ++counts_.impossible;
    problems->impossible.add(check.message);
  }
  return std::nullopt;
}

std::optional<Measurement> MeasurementInput::check(const sensor_msgs::JointState& message, const ros::Time& now) {
  ++counts_.received;
  Measurement measurement;
  if (!hasRightShape(message) || !hasRightTime(message.header.stamp, now, &measurement.reset_first)) {
    return std::nullopt;
  }
  readCables(message, &measurement.cables);
  measurement.header = message.header;
  if (measurement.reset_first) ++counts_.time_jumps;
  ++counts_.accepted;
  last_stamp_ = message.header.stamp;
  clock_went_back_ = false;
  return measurement;
}

}  // namespace cdpr_kinetostatics

// A simulated rig and a node in a namespace of their own, started by a test, and everything that they publish.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/KinetostaticState.h"
#include "node_process.h"
#include "ros/conversions.h"
#include "yaml_parameters.h"

namespace cdpr_kinetostatics {

// Handles what arrives until the condition holds; false if 60 s pass before.
inline bool waitFor(const std::function<bool()>& condition) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(60.0);
  while (!condition() && ros::WallTime::now() < deadline) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
  }
  return condition();
}

class RigScene {
 public:
  // Parameters as YAML, on top of those that make tests exact: catenary for both, nothing gives way or times out.
  RigScene(const std::string& space, const std::string& robot, const std::string& rig, const std::string& node = "{}")
      : space_("/" + space), handle_(space_) {
    ros::param::set(space_ + "/rig", parameters(robot, "{model: catenary, rate: 100.0}", rig));
    ros::param::set(space_ + "/kinetostatics",
                    parameters(robot,
                               "{model: catenary, queue_size: 10000, timeout: 10.0, max_age: 30.0, publish_tf: false, "
                               "diagnostic_period: 0.1}",
                               node));
    listen<geometry_msgs::PoseStamped>("true_pose", &truths);
    listen<sensor_msgs::JointState>("cable_states", &measurements);
    listen<geometry_msgs::PoseWithCovarianceStamped>("platform_pose", &poses);
    listen<geometry_msgs::WrenchStamped>("platform_load", &loads);
    listen<KinetostaticState>("kinetostatic_state", &states);
    const boost::function<void(const diagnostic_msgs::DiagnosticArray&)> on_diagnostics = [this](const auto& m) {
      for (const auto& status : m.status) {
        diagnostics[status.name] = status.message;
        for (const auto& entry : status.values) diagnostic_values[status.name + ": " + entry.key] = entry.value;
      }
    };
    subscribers_.push_back(handle_.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 100, on_diagnostics));
  }

  void startRig() {
    rig_.reset();  // ends the one that runs
    rig_ = std::make_unique<NodeProcess>(RIG_EXECUTABLE, arguments("rig"));
  }
  void killRig() { rig_.reset(); }
  void startNode() {
    launchNode();
    EXPECT_TRUE(ros::service::waitForService(space_ + "/kinetostatics/reset", ros::Duration(60.0)));
  }
  // Does not wait until its services are there.
  void launchNode() {
    node_.reset();
    node_ = std::make_unique<NodeProcess>(NODE_EXECUTABLE, arguments("kinetostatics"));
  }
  NodeProcess& rig() { return *rig_; }
  NodeProcess& node() { return *node_; }
  void start() {
    startNode();
    startRig();
  }

  std::string name(const std::string& what) const { return space_ + "/" + what; }
  ros::NodeHandle& handle() { return handle_; }

  // What diagnostics say of a task, as "input".
  std::string value(const std::string& task, const std::string& key) const {
    const auto found = diagnostic_values.find(space_.substr(1) + "/kinetostatics: " + task + ": " + key);
    return found == diagnostic_values.end() ? "" : found->second;
  }

  bool waitForDiagnostics(const std::string& task, const std::string& words) {
    std::string& said = diagnostics[space_.substr(1) + "/kinetostatics: " + task];
    const bool found = waitFor([&] { return said.find(words) != std::string::npos; });
    EXPECT_TRUE(found) << "'" << words << "' is not what diagnostics say: " << said;
    return found;
  }

  // Waits for that many more estimates.
  bool waitForPoses(std::size_t count) {
    const std::size_t goal = poses.size() + count;
    return waitFor([&] { return poses.size() >= goal; });
  }

  // How many estimates have stamps between two times.
  std::size_t posesBetween(const ros::Time& first, const ros::Time& last) const {
    return static_cast<std::size_t>(std::distance(poses.lower_bound(first), poses.upper_bound(last)));
  }

  // Largest distance of an estimated position from the true one after `since` [m].
  double largestError(const ros::Time& since = ros::Time()) const {
    double largest = 0.0;
    for (const auto& [stamp, pose] : poses) {
      const auto truth = truths.find(stamp);
      if (stamp <= since || truth == truths.end()) continue;
      largest = std::max(largest, (fromMsg(pose.pose.pose).position - fromMsg(truth->second.pose).position).norm());
    }
    return largest;
  }

  // By stamp. The first messages of a process may be missing: it does not wait for those who listen.
  std::map<ros::Time, geometry_msgs::PoseStamped> truths;
  std::map<ros::Time, sensor_msgs::JointState> measurements;
  std::map<ros::Time, geometry_msgs::PoseWithCovarianceStamped> poses;
  std::map<ros::Time, geometry_msgs::WrenchStamped> loads;
  std::map<ros::Time, KinetostaticState> states;
  std::map<std::string, std::string> diagnostics, diagnostic_values;

 private:
  static XmlRpc::XmlRpcValue parameters(const std::string& robot, const std::string& common, const std::string& own) {
    XmlRpc::XmlRpcValue values = toParameter(YAML::Load(common));
    XmlRpc::XmlRpcValue added = toParameter(YAML::Load(own));
    if (added.getType() == XmlRpc::XmlRpcValue::TypeStruct) {
      for (auto& entry : added) values[entry.first] = entry.second;
    }
    values["robot"] = robotParameter(robot);
    return values;
  }

  std::vector<std::string> arguments(const std::string& name) const { return {"__ns:=" + space_, "__name:=" + name}; }

  template <typename Message>
  void listen(const std::string& topic, std::map<ros::Time, Message>* messages) {
    const boost::function<void(const Message&)> add = [messages](const Message& m) { (*messages)[m.header.stamp] = m; };
    subscribers_.push_back(handle_.subscribe<Message>(topic, 10000, add));
  }

  std::string space_;
  ros::NodeHandle handle_;
  std::vector<ros::Subscriber> subscribers_;
  std::unique_ptr<NodeProcess> rig_, node_;
};

}  // namespace cdpr_kinetostatics

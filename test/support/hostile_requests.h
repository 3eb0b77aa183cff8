// Requests and messages that nobody in their right mind would send: drawn around sensible ones, a few of their numbers
// replaced by unlikely ones, and now and then of a wrong shape.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/ForwardKinetostatics.h"
#include "cdpr_kinetostatics/InverseKinetostatics.h"
#include "cdpr_kinetostatics/SetPose.h"
#include "cdpr_kinetostatics/SolveCable.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "ros/conversions.h"

namespace cdpr_kinetostatics {

class HostileRequests {
 public:
  // The robot must outlive the requests. `timeout` of each solve [s].
  HostileRequests(const RobotDescription& robot, double timeout, bool wrong_shapes, unsigned seed)
      : robot_(robot), timeout_(timeout), wrong_shapes_(wrong_shapes), random_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  ForwardKinetostatics::Request forward() {
    ForwardKinetostatics::Request request;
    for (const CableDescription& cable : robot_.cables) {
      const double chord = (robot_.home.transform(cable.attachment) - cable.anchor).norm();
      request.lengths.push_back(integer(0, 3) == 0 ? near(chord) : chord * uniform(0.98, 1.02));
    }
    request.external_wrench = wrench();
    request.use_seed = integer(0, 1) == 1;
    request.seed = pose();
    request.options = options();
    request.profile_points = profilePoints();
    request.compute_stiffness = integer(0, 1) == 1;
    if (isWrong()) spoil(&request.lengths);
    if (isWrong()) request.cable_names = names();
    if (isWrong()) spoil(&request.seed.orientation);
    return request;
  }

  InverseKinetostatics::Request inverse() {
    InverseKinetostatics::Request request;
    request.pose = pose();
    request.free_orientation = integer(0, 1) == 1;
    request.external_wrench = wrench();
    if (integer(0, 1) == 1) {
      for (const CableDescription& cable : robot_.cables) {
        request.preferred_tensions.push_back(near(2.0 * cable.tension_min));
      }
    }
    request.options = options();
    request.profile_points = profilePoints();
    if (isWrong()) spoil(&request.preferred_tensions);
    if (isWrong()) spoil(&request.pose.orientation);
    return request;
  }

  SolveCable::Request cable() {
    const CableProperties& properties = robot_.cables[0].properties;
    SolveCable::Request request;
    request.problem = static_cast<std::uint8_t>(isWrong() ? integer(0, 255) : integer(1, 3));
    request.x = near(8.0);
    request.y = near(-4.0);
    request.length = near(9.0);
    request.horizontal_force = near(300.0);
    request.vertical_force_a = near(200.0);
    request.tension_a = near(400.0);
    if (integer(0, 1) == 1) request.cable_name = robot_.cables[0].name;
    if (isWrong()) request.cable_name = word();
    request.axial_stiffness = near(properties.axial_stiffness);
    request.bending_stiffness = near(properties.bending_stiffness);
    request.linear_density = near(properties.weight / robot_.gravity);
    request.options = options();
    request.profile_points = profilePoints();
    return request;
  }

  SetPose::Request setPose() {
    SetPose::Request request;
    request.pose.header.frame_id = integer(0, 2) == 0 ? word() : "";
    request.pose.pose = pose();
    if (isWrong()) spoil(&request.pose.pose.orientation);
    return request;
  }

  // Stamped around `now`.
  sensor_msgs::JointState measurements(const ros::Time& now) {
    sensor_msgs::JointState message;
    message.header.stamp = isWrong() ? ros::Time(static_cast<std::uint32_t>(random_()), 0) : now;
    message.name = names();
    for (std::size_t i = 0; i < message.name.size(); ++i) {
      message.position.push_back(near(uniform(1.0, 20.0)));
      message.effort.push_back(near(uniform(0.0, 1000.0)));
    }
    if (isWrong()) spoil(&message.position);
    if (isWrong()) spoil(&message.effort);
    return message;
  }

 private:
  bool isWrong() { return wrong_shapes_ && integer(0, 9) == 0; }

  double near(double value) {
    static const double kUnlikely[] = {
        0.0,         -0.0, 1e-300, -1e-12, 1e-9,  1e-3, -1.0,  1e3,    -1e3,
        1e6,         -1e6, 1e9,    1e12,   -1e12, 1e13, 1e300, -1e300, std::numeric_limits<double>::infinity(),
        std::nan("")};
    if (integer(0, 9) > 0) return value * uniform(0.9, 1.1);
    return kUnlikely[integer(0, static_cast<int>(std::size(kUnlikely)) - 1)];
  }

  std::string word() {
    static const char* const kWords[] = {"", "rope", "cable0", "CABLE1", "cable99", "%s%n", "\xff\xfe", "a/b", " "};
    const int k = integer(0, static_cast<int>(std::size(kWords)));
    return k < static_cast<int>(std::size(kWords)) ? kWords[k] : std::string(10000, 'x');
  }

  std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const CableDescription& cable : robot_.cables) names.push_back(isWrong() ? word() : cable.name);
    std::shuffle(names.begin(), names.end(), random_);
    if (isWrong()) names.resize(static_cast<std::size_t>(integer(0, 30)));
    return names;
  }

  // Too few, too many, or none.
  void spoil(std::vector<double>* list) { list->resize(static_cast<std::size_t>(integer(0, 30)), near(1.0)); }
  void spoil(geometry_msgs::Quaternion* orientation) {
    orientation->x = near(uniform(-1.0, 1.0));
    orientation->y = near(uniform(-1.0, 1.0));
    orientation->z = near(uniform(-1.0, 1.0));
    orientation->w = near(uniform(-1.0, 1.0));
  }

  int profilePoints() { return isWrong() ? integer(-5, 2000000000) : 5 * integer(0, 1); }

  SolverOptions options() {
    SolverOptions options;
    options.model = static_cast<std::uint8_t>(isWrong() ? integer(0, 255) : integer(0, 9));
    options.accuracy = isWrong() ? near(1e-4) : 0.0;
    options.tolerance = near(1e-8);
    options.timeout = ros::Duration(timeout_);
    return options;
  }

  geometry_msgs::Pose pose() {
    geometry_msgs::Pose pose = toMsg(robot_.home);
    pose.position.x = near(pose.position.x + 0.1 * uniform(-1.0, 1.0) * robot_.span());
    pose.position.y = near(pose.position.y + 0.1 * uniform(-1.0, 1.0) * robot_.span());
    pose.position.z = near(pose.position.z);
    return pose;
  }

  geometry_msgs::Wrench wrench() {
    geometry_msgs::Wrench wrench;
    wrench.force.x = near(0.1 * robot_.weight());
    wrench.force.z = near(0.1 * robot_.weight());
    return wrench;
  }

  const RobotDescription& robot_;
  const double timeout_;
  const bool wrong_shapes_;
  std::mt19937 random_;
};

}  // namespace cdpr_kinetostatics

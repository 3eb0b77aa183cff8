// The node: its parameters and the services that answer from them.
#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <vector>

#include "cdpr_kinetostatics/ros/parameters.h"

namespace cdpr_kinetostatics {

// Services do not share anything but the constant parameters: they may run in any number of threads.
class KinetostaticsNode {
 public:
  // Throws std::invalid_argument if the parameters are wrong.
  explicit KinetostaticsNode(const ros::NodeHandle& private_handle);

 private:
  ros::NodeHandle handle_;
  NodeParameters parameters_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace cdpr_kinetostatics

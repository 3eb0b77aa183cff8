// The node: its parameters, the services that answer from them, and the estimator.
#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <vector>

#include "ros/clock_watch.h"
#include "ros/diagnostics.h"
#include "ros/estimator_loop.h"
#include "ros/home_service.h"
#include "ros/parameters.h"

namespace cdpr_kinetostatics {

// The three kinetostatic services share nothing but the parameters, which never change: they may run in any number of
// threads. The estimator has threads of its own.
class KinetostaticsNode {
 public:
  // Throws std::invalid_argument if the parameters are wrong. Topics are those of `handle`.
  KinetostaticsNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);

 private:
  ros::NodeHandle private_handle_;
  NodeParameters parameters_;
  EstimatorLoop loop_;
  HomeService home_;
  Diagnostics diagnostics_;
  ClockWatch clock_watch_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace cdpr_kinetostatics

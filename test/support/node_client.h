// Calls of the node's services from tests: waits until the node is there, and judges what comes back.
#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <string>

#include "cdpr_kinetostatics/ForwardKinetostatics.h"
#include "cdpr_kinetostatics/InverseKinetostatics.h"
#include "cdpr_kinetostatics/SolveCable.h"
#include "ros/service_reply.h"

namespace cdpr_kinetostatics {

// A persistent connection, closed by the client: where the server closes it after its answer, roscpp's client
// sometimes sees the end of the connection before the answer and reports a failed call (ros_comm issue 1976).
template <typename Service>
ros::ServiceClient connect(const std::string& service) {
  constexpr bool kPersistent = true;
  return ros::NodeHandle().serviceClient<Service>(service, kPersistent);
}

class NodeClient {
 public:
  explicit NodeClient(const std::string& node) : node_(node) {}

  ForwardKinetostatics::Response forward(const ForwardKinetostatics::Request& request) const {
    return call<ForwardKinetostatics>("forward_kinetostatics", request);
  }
  InverseKinetostatics::Response inverse(const InverseKinetostatics::Request& request) const {
    return call<InverseKinetostatics>("inverse_kinetostatics", request);
  }
  SolveCable::Response cable(const SolveCable::Request& request) const {
    return call<SolveCable>("solve_cable", request);
  }

 private:
  template <typename Service>
  typename Service::Response call(const std::string& name, typename Service::Request request) const {
    const std::string service = node_ + "/" + name;
    EXPECT_TRUE(ros::service::waitForService(service, ros::Duration(30.0))) << service << " is not offered";
    typename Service::Response response;
    EXPECT_TRUE(connect<Service>(service).call(request, response)) << service << " did not answer";
    return response;
  }

  std::string node_;
};

inline bool isFinite(const ForwardKinetostatics::Response& response) {
  return allFinite(response.report) && allFinite(response.pose) && allFinite(response.cables) &&
         allFinite(response.stiffness);
}
inline bool isFinite(const InverseKinetostatics::Response& response) {
  return allFinite(response.report) && allFinite(response.pose) && allFinite(response.cables) &&
         allFinite(response.lengths);
}
inline bool isFinite(const SolveCable::Response& response) {
  return allFinite(response.report) && allFinite(response.cable) && allFinite(response.x) && allFinite(response.y);
}

}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/ros/kinetostatics_node.h"

#include <ros/console.h>
#include <ros/param.h>

#include "cdpr_kinetostatics/ros/cable_service.h"
#include "cdpr_kinetostatics/ros/forward_service.h"
#include "cdpr_kinetostatics/ros/inverse_service.h"
#include "cdpr_kinetostatics/ros/text.h"

namespace cdpr_kinetostatics {

namespace {

NodeParameters fromServer(const ros::NodeHandle& private_handle) {
  XmlRpc::XmlRpcValue values;
  ros::param::get(private_handle.getNamespace(), values);
  const LoadedParameters loaded = loadParameters(values);
  for (const std::string& warning : loaded.warnings) ROS_WARN_STREAM(warning);
  return loaded.parameters;
}

// Advertises a service whose outcome is in its response: the call itself always succeeds.
template <typename Service, typename Serve>
ros::ServiceServer advertise(ros::NodeHandle& handle, const NodeParameters& parameters, const char* name, Serve serve) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> callback = [&parameters, serve](Request& request,
                                                                                   Response& response) {
    response = serve(parameters, request);
    return true;
  };
  return handle.advertiseService(name, callback);
}

std::string summary(const NodeParameters& parameters) {
  const RobotDescription& robot = parameters.robot;
  return text("robot '", robot.name, "': ", robot.type == PlatformType::kPointMass ? "point mass" : "rigid body",
              " of ", robot.mass, " kg on ", robot.cables.size(), " cables; model ", modelName(parameters.model),
              ", tolerance ", parameters.tolerance, ", timeout ", parameters.timeout, " s");
}

}  // namespace

KinetostaticsNode::KinetostaticsNode(const ros::NodeHandle& private_handle)
    : handle_(private_handle), parameters_(fromServer(private_handle)) {
  servers_.push_back(advertise<ForwardKinetostatics>(handle_, parameters_, "forward_kinetostatics", serveForward));
  servers_.push_back(advertise<InverseKinetostatics>(handle_, parameters_, "inverse_kinetostatics", serveInverse));
  servers_.push_back(advertise<SolveCable>(handle_, parameters_, "solve_cable", serveCable));

  std::string services;
  for (const ros::ServiceServer& server : servers_) services += " " + server.getService();
  ROS_INFO_STREAM(summary(parameters_));
  ROS_INFO_STREAM("services:" << services);
}

}  // namespace cdpr_kinetostatics

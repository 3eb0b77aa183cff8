#include "ros/kinetostatics_node.h"

#include <ros/console.h>
#include <ros/param.h>

#include "cable/text.h"
#include "ros/cable_service.h"
#include "ros/estimator_services.h"
#include "ros/forward_service.h"
#include "ros/inverse_service.h"

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
ros::ServiceServer advertise(ros::NodeHandle& handle, const char* name, Serve serve) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> callback = [serve](Request& request, Response& response) {
    response = serve(request);
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

KinetostaticsNode::KinetostaticsNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : private_handle_(private_handle),
      parameters_(fromServer(private_handle)),
      loop_(handle, parameters_),
      home_(loop_, parameters_),
      diagnostics_(private_handle, loop_, parameters_),
      clock_watch_(private_handle) {
  using Forward = ForwardKinetostatics;
  using Inverse = InverseKinetostatics;
  using Reset = std_srvs::Trigger;
  ros::NodeHandle& own = private_handle_;
  const NodeParameters& p = parameters_;
  EstimatorLoop& loop = loop_;
  servers_ = {
      advertise<Forward>(own, "forward_kinetostatics", [&p](const Forward::Request& r) { return serveForward(p, r); }),
      advertise<Inverse>(own, "inverse_kinetostatics", [&p](const Inverse::Request& r) { return serveInverse(p, r); }),
      advertise<SolveCable>(own, "solve_cable", [&p](const SolveCable::Request& r) { return serveCable(p, r); }),
      advertise<SetPose>(own, "set_pose", [&p, &loop](const SetPose::Request& r) { return serveSetPose(loop, p, r); }),
      advertise<Home>(own, "home", [this](const Home::Request& r) { return home_.serve(r); }),
      advertise<Reset>(own, "reset", [&loop](const Reset::Request&) { return serveReset(loop); }),
  };

  std::string services;
  for (const ros::ServiceServer& server : servers_) services += " " + server.getService();
  ROS_INFO_STREAM(summary(parameters_));
  ROS_INFO_STREAM("services:" << services);
}

}  // namespace cdpr_kinetostatics

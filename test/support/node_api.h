// A node as ROS' own programs see it: its process.
#pragma once

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <fstream>
#include <string>

namespace cdpr_kinetostatics {

// -1 if the node does not answer.
inline int pidOf(const std::string& node) {
  XmlRpc::XmlRpcValue arguments, answer, payload;
  arguments[0] = ros::this_node::getName();
  arguments[1] = node;
  constexpr bool kWaitForMaster = false;
  if (!ros::master::execute("lookupNode", arguments, answer, payload, kWaitForMaster)) return -1;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(static_cast<std::string&>(payload), host, port)) return -1;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue caller, pid;
  caller[0] = ros::this_node::getName();
  return client.execute("getPid", caller, pid) && pid.size() == 3 ? static_cast<int&>(pid[2]) : -1;
}

// Memory of a process [MiB], -1 if there is no such process.
inline double residentMemory(int pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string word; status >> word;) {
    if (word != "VmRSS:") continue;
    double kibibytes = 0.0;
    status >> kibibytes;
    return kibibytes / 1024.0;
  }
  return -1.0;
}

}  // namespace cdpr_kinetostatics

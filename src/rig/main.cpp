#include <ros/ros.h>

#include <cstdio>
#include <stdexcept>

#include "rig/parameters.h"
#include "rig/simulator.h"
#include "ros/clock_watch.h"

int main(int argc, char** argv) {
  setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // what the node says appears at once, in a pipe too
  ros::init(argc, argv, "rig_simulator");
  const ros::NodeHandle handle;
  const ros::NodeHandle private_handle("~");
  try {
    XmlRpc::XmlRpcValue values;
    private_handle.getParam(private_handle.getNamespace(), values);
    const cdpr_kinetostatics::LoadedRigParameters loaded = cdpr_kinetostatics::loadRigParameters(values);
    for (const std::string& warning : loaded.warnings) ROS_WARN_STREAM(warning);
    const cdpr_kinetostatics::ClockWatch clock_watch(handle);
    cdpr_kinetostatics::RigSimulator(handle, private_handle, loaded.parameters).run();
  } catch (const std::exception& problem) {
    ROS_FATAL_STREAM(problem.what());
    return 1;
  }
  return 0;
}

#include <ros/ros.h>

#include <cstdio>
#include <stdexcept>

#include "ros/kinetostatics_node.h"

int main(int argc, char** argv) {
  constexpr int kServiceThreads = 4;
  setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // what the node says appears at once, in a pipe too
  ros::init(argc, argv, "kinetostatics");
  const ros::NodeHandle handle;  // outlives the try: without a handle nothing is logged
  try {
    const cdpr_kinetostatics::KinetostaticsNode node(handle, ros::NodeHandle("~"));
    ros::AsyncSpinner spinner(kServiceThreads);
    spinner.start();
    ros::waitForShutdown();
  } catch (const std::exception& problem) {
    ROS_FATAL_STREAM(problem.what());
    return 1;
  }
  return 0;
}

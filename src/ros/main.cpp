#include <ros/ros.h>

#include <stdexcept>

#include "cdpr_kinetostatics/ros/kinetostatics_node.h"

int main(int argc, char** argv) {
  constexpr int kServiceThreads = 4;
  ros::init(argc, argv, "kinetostatics");
  try {
    const cdpr_kinetostatics::KinetostaticsNode node(ros::NodeHandle("~"));
    ros::AsyncSpinner spinner(kServiceThreads);
    spinner.start();
    ros::waitForShutdown();
  } catch (const std::invalid_argument& problem) {
    ROS_FATAL_STREAM(problem.what());
    return 1;
  }
  return 0;
}

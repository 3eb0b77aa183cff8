// Simulated time that never comes: with use_sim_time and nobody on /clock, all of ROS stands still without a word.
#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

namespace cdpr_kinetostatics {

inline constexpr const char* kNoTime =
    "there is no time: use_sim_time is set, and nothing has come on /clock; play a bag with --clock, or unset "
    "use_sim_time";

// True until the first message on /clock, if time is simulated.
bool isTimeMissing();

// Warns as long as time is missing. Its timer is one of wall time: others would wait for /clock, too.
class ClockWatch {
 public:
  explicit ClockWatch(const ros::NodeHandle& handle);

 private:
  ros::WallTimer timer_;
};

}  // namespace cdpr_kinetostatics

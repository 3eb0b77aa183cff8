#include "ros/clock_watch.h"

#include <ros/console.h>
#include <ros/time.h>

namespace cdpr_kinetostatics {

namespace {

constexpr double kPeriod = 3.0;  // between warnings [s]: long enough for whatever plays the clock to start

}  // namespace

bool isTimeMissing() { return ros::Time::isSimTime() && ros::Time::now().isZero(); }

ClockWatch::ClockWatch(const ros::NodeHandle& handle)
    : timer_(handle.createWallTimer(ros::WallDuration(kPeriod), [](const ros::WallTimerEvent&) {
        if (isTimeMissing()) ROS_WARN_STREAM(kNoTime);
      })) {}

}  // namespace cdpr_kinetostatics

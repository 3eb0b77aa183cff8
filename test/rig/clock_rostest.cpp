// Simulated time that is missing, jumps, and comes to its end: the estimate is right, or there is none.

#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "node_client.h"
#include "scene.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kExact = 1e-6;              // [m], of estimates from exact measurements
constexpr double kEndOfTime = 4294967295.0;  // [s], all that the seconds of a stamp can hold
constexpr std::size_t kEnough = 30;          // estimates

// Plays the clock at about the speed of the wall's.
class SimulatedClock {
 public:
  explicit SimulatedClock(double start)
      : time_(start),
        publisher_(ros::NodeHandle().advertise<rosgraph_msgs::Clock>("/clock", 10)),
        thread_([this] { run(); }) {}
  SimulatedClock(const SimulatedClock&) = delete;
  SimulatedClock& operator=(const SimulatedClock&) = delete;
  ~SimulatedClock() {
    ended_ = true;
    thread_.join();
  }

  void jumpTo(double time) { time_ = time; }
  double time() const { return time_; }

 private:
  void run() {
    constexpr double kTick = 0.002;  // [s]
    while (!ended_) {
      rosgraph_msgs::Clock message;
      double now = time_;
      message.clock = ros::Time(now);
      publisher_.publish(message);
      ros::WallDuration(kTick).sleep();
      time_.compare_exchange_strong(now, std::min(now + kTick, kEndOfTime));  // unless it has jumped meanwhile
    }
  }

  std::atomic<double> time_;
  std::atomic<bool> ended_{false};
  ros::Publisher publisher_;
  std::thread thread_;
};

// Waits for estimates of the next minute.
bool waitForPosesFrom(const RigScene& scene, double time) {
  const ros::Time first(time), last(std::min(time + 60.0, kEndOfTime));
  return waitFor([&] { return scene.posesBetween(first, last) >= kEnough; });
}

TEST(Clock, IsMissedUntilItTicks) {
  RigScene scene("no_clock", "cogiro", "{}");
  scene.launchNode();
  scene.startRig();
  EXPECT_TRUE(scene.node().waitFor("nothing has come on /clock")) << scene.node().output();
  EXPECT_TRUE(scene.rig().waitFor("nothing has come on /clock")) << scene.rig().output();
  scene.waitForDiagnostics("input", "nothing has come on /clock");
  EXPECT_TRUE(scene.measurements.empty());
  const SimulatedClock clock(1000.0);
  EXPECT_TRUE(waitForPosesFrom(scene, 1000.0));
  EXPECT_LT(scene.largestError(), kExact);
  scene.waitForDiagnostics("input", "measurements arrive");
}

TEST(Clock, MayJumpBackAndForth) {
  SimulatedClock clock(5000.0);
  RigScene scene("jumps", "cogiro", "{}");
  scene.start();
  EXPECT_TRUE(waitForPosesFrom(scene, 5000.0));
  for (const double time : {100.0, 10000.0, 3000000000.0, 1.0}) {
    SCOPED_TRACE(time);
    clock.jumpTo(time);
    EXPECT_TRUE(waitForPosesFrom(scene, time));
    EXPECT_LT(scene.largestError(), kExact);
  }
  EXPECT_TRUE(scene.node().isRunning());
  EXPECT_TRUE(scene.rig().isRunning());
  EXPECT_EQ(scene.value("input", "time went backwards").empty(), false);
}

TEST(Clock, MayComeToTheEndOfItsRange) {
  SimulatedClock clock(kEndOfTime - 2.0);
  RigScene scene("end", "cogiro", "{}");
  scene.start();
  EXPECT_TRUE(waitForPosesFrom(scene, kEndOfTime - 60.0));
  ASSERT_TRUE(waitFor([&] { return clock.time() == kEndOfTime; }));
  std_srvs::Trigger reset;
  EXPECT_TRUE(connect<std_srvs::Trigger>(scene.name("kinetostatics/reset")).call(reset));
  clock.jumpTo(1000.0);
  EXPECT_TRUE(waitForPosesFrom(scene, 1000.0));
  EXPECT_LT(scene.largestError(), kExact);
  EXPECT_TRUE(scene.node().isRunning());
  EXPECT_TRUE(scene.rig().isRunning());
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rig_clock_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

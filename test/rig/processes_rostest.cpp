// What happens to processes: they are killed and started again, they pause, and they get too little of the processor.
// The estimate is right, or there is none.

#include <ros/ros.h>

#include "scene.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kExact = 1e-6;  // [m], of estimates from exact measurements

TEST(Processes, NodeThatIsKilledFindsThePlatformAnew) {
  RigScene scene("killed", "cogiro", "{}");
  scene.start();
  ASSERT_TRUE(scene.waitForPoses(50));
  scene.startNode();  // kills the one that runs
  const ros::Time killed = scene.poses.rbegin()->first;
  ASSERT_TRUE(scene.waitForPoses(50));
  EXPECT_GT(scene.poses.rbegin()->first, killed);
  EXPECT_LT(scene.largestError(), kExact);
  scene.waitForDiagnostics("solver", "solves converge");
}

TEST(Processes, RigThatPausesIsMissedAndTakenUpAgain) {
  RigScene scene("paused", "cogiro", "{}", "{max_age: 3.0}");
  scene.start();
  ASSERT_TRUE(scene.waitForPoses(50));
  scene.rig().pause();
  scene.waitForDiagnostics("input", "nothing on " + scene.name("cable_states"));
  scene.rig().resume();
  ASSERT_TRUE(scene.waitForPoses(50));
  EXPECT_LT(scene.largestError(), kExact);
  scene.waitForDiagnostics("input", "measurements arrive");
}

// The processor is taken away again and again, until measurements have given way to newer ones.
TEST(Processes, NodeThatStarvesGivesFewerEstimatesAndRightOnes) {
  RigScene scene("starved", "cogiro", "{}", "{queue_size: 1}");
  scene.start();
  ASSERT_TRUE(scene.waitForPoses(20));
  const auto gave_way = [&] {
    const std::string count = scene.value("input", "gave way to newer ones");
    return count.empty() ? 0 : std::stoi(count);
  };
  constexpr int kEnough = 20, kMostRounds = 200;
  for (int round = 0; round < kMostRounds && gave_way() < kEnough; ++round) {
    scene.node().pause();
    const std::size_t sent = scene.measurements.size() + 20;
    ASSERT_TRUE(waitFor([&] { return scene.measurements.size() >= sent; }));
    scene.node().resume();
    ASSERT_TRUE(scene.waitForPoses(1)) << "round " << round;
  }
  EXPECT_GE(gave_way(), kEnough);
  EXPECT_LT(scene.poses.size(), scene.measurements.size());
  EXPECT_LT(scene.largestError(), kExact);
  ASSERT_TRUE(scene.waitForPoses(50));
  scene.waitForDiagnostics("input", "measurements arrive");
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rig_processes_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

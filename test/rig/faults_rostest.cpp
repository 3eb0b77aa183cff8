// What goes wrong with a robot's sensors and programs, made by the simulated rig: the estimate goes on, or comes back.

#include <std_srvs/Trigger.h>

#include <algorithm>
#include <cmath>

#include "node_client.h"
#include "scene.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kExact = 1e-6;  // [m], of estimates from exact measurements

// Cables that are flagged in a state.
std::vector<std::size_t> flagged(const KinetostaticState& state) {
  std::vector<std::size_t> cables;
  for (std::size_t i = 0; i < state.outlier.size(); ++i) {
    if (state.outlier[i]) cables.push_back(i);
  }
  return cables;
}

TEST(RigFaults, MessagesThatDropOutAreNotMissed) {
  RigScene scene("dropout", "cogiro", "{dropout: 0.3}");
  scene.start();
  ASSERT_TRUE(scene.waitForPoses(200));
  // The node and this test subscribe one after the other.
  const ros::Time first = std::max(scene.measurements.begin()->first, scene.poses.begin()->first);
  const ros::Time last = scene.poses.rbegin()->first;
  double sent = 0.0, moved = 0.0, estimated = 0.0;
  for (const auto& [stamp, truth] : scene.truths) {
    if (stamp < first || stamp > last) continue;
    moved += 1.0;
    sent += static_cast<double>(scene.measurements.count(stamp));
    estimated += static_cast<double>(scene.poses.count(stamp));
    EXPECT_EQ(scene.poses.count(stamp), scene.measurements.count(stamp)) << "a pose for every message, and no other";
  }
  EXPECT_NEAR(sent, 0.7 * moved, 5.0 * std::sqrt(0.7 * 0.3 * moved));
  EXPECT_EQ(estimated, sent);
  EXPECT_LT(scene.largestError(), kExact);
  scene.waitForDiagnostics("input", "measurements arrive");
}

TEST(RigFaults, StuckCellIsFlaggedAsLongAsItIsStuck) {
  RigScene scene("stuck", "cogiro",
                 "{length_noise: 0.001, tension_noise: 5.0, faults: [{kind: stuck_tension, cable: cable2, "
                 "value: 900.0, start: 1.0, end: 3.0}]}");
  scene.start();
  // Over once the cell has been stuck, and then right again for a while.
  ASSERT_TRUE(waitFor([&] {
    int stuck = 0, sound_after = 0;
    for (const auto& [stamp, state] : scene.states) {
      const auto sent = scene.measurements.find(stamp);
      if (sent == scene.measurements.end()) continue;
      if (sent->second.effort[2] == 900.0) {
        ++stuck;
      } else if (stuck > 0) {
        ++sound_after;
      }
    }
    return stuck > 150 && sound_after > 100;
  }));
  for (const auto& [stamp, state] : scene.states) {
    const auto sent = scene.measurements.find(stamp);
    if (sent == scene.measurements.end()) continue;
    ASSERT_EQ(state.report.code, SolveReport::CONVERGED) << state.report.message;
    const std::vector<std::size_t> expected(sent->second.effort[2] == 900.0 ? 1 : 0, 2);
    EXPECT_EQ(flagged(state), expected);
  }
  EXPECT_LT(scene.largestError(), 0.02) << "six standard deviations of the position are about 9 mm";
}

TEST(RigFaults, ValuesThatAreNotNumbersAreLeftOut) {
  RigScene scene("nan", "cogiro",
                 "{faults: [{kind: no_length, cable: cable0}, {kind: no_tension, cable: cable4, start: 0.5}]}");
  scene.start();
  ASSERT_TRUE(waitFor([&] {
    return !scene.poses.empty() && !scene.measurements.empty() &&
           std::isnan(scene.measurements.rbegin()->second.effort[4]);
  }));
  const ros::Time both = scene.measurements.rbegin()->first;
  ASSERT_TRUE(scene.waitForPoses(100));
  EXPECT_TRUE(std::isnan(scene.measurements.rbegin()->second.position[0]));
  EXPECT_GT(scene.poses.rbegin()->first, both);
  EXPECT_LT(scene.largestError(), kExact);
  for (const auto& [stamp, state] : scene.states) EXPECT_TRUE(flagged(state).empty());
  scene.waitForDiagnostics("input", "measurements are missing: no ");
}

TEST(RigFaults, RigOfAnotherRobotIsRefused) {
  RigScene scene("names", "cogiro", "{}");
  XmlRpc::XmlRpcValue robot = robotParameter("desktop_music_wire");
  for (int i = 0; i < robot["points"].size(); ++i) robot["points"][i]["name"] = "wire" + std::to_string(i);
  ros::param::set(scene.name("rig/robot"), robot);
  scene.start();
  scene.waitForDiagnostics("input", "every message is refused: none of the names is a cable of cogiro");
  EXPECT_TRUE(scene.states.empty());
}

TEST(RigFaults, EstimateComesBackWhenTheRigIsRestarted) {
  RigScene scene("restart", "cogiro", "{path_period: 4.0}", "{max_age: 5.0}");
  scene.startNode();
  scene.waitForDiagnostics("input", "nothing received; publishers on that topic: 0");
  scene.startRig();
  ASSERT_TRUE(scene.waitForPoses(150));
  scene.killRig();
  scene.waitForDiagnostics("input", "nothing on " + scene.name("cable_states"));
  const ros::Time silent = scene.poses.rbegin()->first;
  // The new one begins at home, where the old one was not: the platform jumps.
  scene.startRig();
  ASSERT_TRUE(scene.waitForPoses(100));
  EXPECT_LT(scene.largestError(silent), kExact);
  scene.waitForDiagnostics("input", "measurements arrive");
  scene.waitForDiagnostics("solver", "solves converge");
}

TEST(RigFaults, ResetInTheMiddleStartsColdAndGoesOn) {
  RigScene scene("reset", "cogiro", "{}");
  scene.start();
  ASSERT_TRUE(scene.waitForPoses(50));
  const ros::Time before = scene.poses.rbegin()->first;
  std_srvs::Trigger reset;
  ASSERT_TRUE(connect<std_srvs::Trigger>(scene.name("kinetostatics/reset")).call(reset));
  ASSERT_TRUE(scene.waitForPoses(100));
  int cold = 0;
  for (const auto& [stamp, state] : scene.states) cold += stamp > before && !state.report.warm_started ? 1 : 0;
  EXPECT_EQ(cold, 1);
  EXPECT_LT(scene.largestError(), kExact);
}

// The payload is lighter than what would slacken a cable, and far above what the tensions cannot tell.
TEST(RigLoads, PayloadIsFoundWhenItIsTakenUp) {
  constexpr double kWeight = 50.0;  // [N]
  RigScene scene("payload", "cogiro", "{loads: [{time: 1.5, wrench: [0, 0, -50.0, 0, 0, 0]}]}", "{known_load: false}");
  scene.start();
  const auto found = [&] { return scene.loads.empty() ? 0.0 : scene.loads.rbegin()->second.wrench.force.z; };
  ASSERT_TRUE(waitFor([&] { return found() < -0.5 * kWeight; })) << found();
  ASSERT_TRUE(scene.waitForPoses(50));
  bool taken_up = false;
  int before = 0, after = 0;
  for (const auto& [stamp, load] : scene.loads) {
    const double z = load.wrench.force.z;
    taken_up |= z < -0.5 * kWeight;
    ++(taken_up ? after : before);
    EXPECT_NEAR(z, taken_up ? -kWeight : 0.0, 1e-3) << "nothing lies between the two";
    EXPECT_NEAR(load.wrench.force.x, 0.0, 1e-3);
    EXPECT_NEAR(load.wrench.torque.y, 0.0, 1e-3);
  }
  EXPECT_GT(before, 10);
  EXPECT_GT(after, 10);
  EXPECT_LT(scene.largestError(), kExact);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rig_faults_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

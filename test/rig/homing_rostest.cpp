// ~home on the simulated rig: winches with unknown zeros, a platform at rest at its home, and then offsets that are
// right within their deviations; refused while the platform moves or the pose is another; kept over a restart.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <cstdio>

#include "cdpr_kinetostatics/Home.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "node_client.h"
#include "scene.h"

namespace cdpr_kinetostatics {
namespace {

constexpr const char* kUnknownZeros = "offset_error: 0.02, length_noise: 1.0e-3, tension_noise: 5.0";

Home::Response home(const RigScene& scene, const Home::Request& request) {
  Home::Request asked = request;
  Home::Response response;
  EXPECT_TRUE(connect<Home>(scene.name("kinetostatics/home")).call(asked, response));
  return response;
}

Home::Request atHome(const RobotDescription& robot) {
  Home::Request request;
  request.pose = toMsg(robot.home);
  request.use_tensions = 1;
  return request;
}

// Mean of so many estimates from now on, less the true position [m]: noise averages out, wrong offsets stay.
double meanError(RigScene& scene, std::size_t count) {
  EXPECT_TRUE(scene.waitForPoses(1));
  const ros::Time since = scene.poses.rbegin()->first;
  EXPECT_TRUE(scene.waitForPoses(count));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int used = 0;
  for (const auto& [stamp, pose] : scene.poses) {
    const auto truth = scene.truths.find(stamp);
    if (stamp <= since || truth == scene.truths.end()) continue;
    sum += fromMsg(pose.pose.pose).position - fromMsg(truth->second.pose).position;
    ++used;
  }
  EXPECT_GT(used, 0);
  return sum.norm() / used;
}

std::vector<double> trueLengths(const RobotDescription& robot) {
  InverseRequest request;
  request.pose = robot.home;
  RobotSolverOptions options;
  options.model = Model::kCatenary;
  options.tolerance = 1e-10;
  options.timeout = std::chrono::duration<double>(20.0);
  return lengthsOf(solveInverse(robot, request, options));
}

TEST(Homing, FindsUnknownZerosAndKeepsThemOverARestart) {
  const std::string file = testing::TempDir() + "homing_rostest_offsets.yaml";
  std::remove(file.c_str());
  const RobotDescription robot = loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot;
  RigScene scene("homing", "cogiro", std::string("{path: target, ") + kUnknownZeros + "}",
                 "{offsets_file: '" + file + "'}");
  scene.start();
  ASSERT_TRUE(scene.waitForPoses(10));
  const double before = meanError(scene, 50);
  EXPECT_GT(before, 5e-3) << "offsets of 20 mm show";

  const Home::Response response = home(scene, atHome(robot));
  ASSERT_EQ(response.report.code, SolveReport::CONVERGED) << response.report.message;
  EXPECT_TRUE(response.applied);
  ASSERT_EQ(response.offsets.size(), robot.cables.size());

  // The mean of many later positions, with the offset, is the true length: within five deviations, which the eight
  // cables of one test in ten thousand exceed.
  ASSERT_TRUE(scene.waitForPoses(400));
  const std::vector<double> lengths = trueLengths(robot);
  const auto samples = static_cast<double>(scene.measurements.size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    double mean = 0.0;
    for (const auto& [stamp, message] : scene.measurements) mean += message.position[i] / samples;
    const double stddev = std::hypot(response.stddev[i], 1e-3 / std::sqrt(samples));
    EXPECT_LT(std::abs(mean + response.offsets[i] - lengths[i]), 5.0 * stddev) << robot.cables[i].name;
    EXPECT_LT(response.stddev[i], 1e-3);
  }
  EXPECT_LT(meanError(scene, 100), 1e-3);

  scene.startNode();
  ASSERT_TRUE(scene.waitForPoses(10));
  EXPECT_LT(meanError(scene, 100), 1e-3) << "after a restart";
  std::remove(file.c_str());
}

TEST(Homing, IsRefusedWhereThePoseIsAnother) {
  const RobotDescription robot = loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot;
  RigScene scene("elsewhere", "cogiro", "{path: target, tension_noise: 5.0}");
  scene.start();
  ASSERT_TRUE(scene.waitForPoses(10));
  Home::Request request = atHome(robot);
  request.pose.position.x += 1.0;
  Home::Response response = home(scene, request);
  EXPECT_EQ(response.report.code, SolveReport::INVALID_INPUT);
  EXPECT_NE(response.report.message.find("contradict this pose"), std::string::npos) << response.report.message;
  EXPECT_FALSE(response.applied);
  EXPECT_TRUE(response.offsets.empty());
  request = atHome(robot);
  request.use_tensions = 0;
  response = home(scene, request);
  EXPECT_NE(response.report.message.find("8 cables for 6 freedoms"), std::string::npos) << response.report.message;
  request.samples = 2;
  EXPECT_NE(home(scene, request).report.message.find("samples is 2: expected"), std::string::npos);
  request = atHome(robot);
  request.window = ros::Duration(100.0);
  EXPECT_NE(home(scene, request).report.message.find("window is 100 s: expected"), std::string::npos);
}

TEST(Homing, IsRefusedWhileThePlatformMoves) {
  const RobotDescription robot = loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot;
  RigScene scene("moving", "cogiro", "{path: circle, path_radius: 0.3, path_period: 10.0, length_noise: 1.0e-3}");
  scene.start();
  ASSERT_TRUE(scene.waitForPoses(10));
  const Home::Response response = home(scene, atHome(robot));
  EXPECT_EQ(response.report.code, SolveReport::INVALID_INPUT);
  EXPECT_NE(response.report.message.find("not at rest"), std::string::npos) << response.report.message;
  EXPECT_FALSE(response.applied);
}

TEST(Homing, WithoutMeasurementsItSaysSoWhenTheWindowIsOver) {
  const RobotDescription robot = loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot;
  RigScene scene("silent", "cogiro", "{}");
  scene.startNode();
  Home::Request request = atHome(robot);
  request.window = ros::Duration(0.2);
  const Home::Response response = home(scene, request);
  EXPECT_EQ(response.report.code, SolveReport::INVALID_INPUT);
  EXPECT_NE(response.report.message.find("0 samples of its length"), std::string::npos) << response.report.message;
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rig_homing_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

// What the sentences of refused robot problems name. That the solvers make the checks is in refusal_test.
#include "robot/robot_checks.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {
namespace {

const RobotDescription& cogiro() {
  static const RobotDescription robot = loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot;
  return robot;
}

void expectRefused(const Status& status, const std::string& start) {
  EXPECT_EQ(status.code, Code::kInvalidInput);
  EXPECT_EQ(status.message.substr(0, start.size()), start) << status.message;
  EXPECT_NE(status.message.find(": expected "), std::string::npos) << status.message;
}

TEST(RobotChecks, RefuseWhatIsNoRobot) {
  EXPECT_TRUE(checkRobot(cogiro()).ok());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double mass : {0.0, -1.0, 1e308, nan}) {
    RobotDescription robot = cogiro();
    robot.mass = mass;
    expectRefused(checkRobot(robot), "mass is ");
  }
  RobotDescription robot = cogiro();
  robot.gravity = 1e100;
  expectRefused(checkRobot(robot), "gravity is ");
  robot = cogiro();
  robot.mass = 1e10;
  robot.gravity = 1e5;
  expectRefused(checkRobot(robot), "the platform's weight, mass times gravity, is ");
  robot = cogiro();
  robot.com.z() = 1e100;
  expectRefused(checkRobot(robot), "com is ");
  robot = cogiro();
  robot.cables.clear();
  expectRefused(checkRobot(robot), "the number of cables is 0");
  const std::string cable = "cable '" + cogiro().cables[2].name + "': ";
  robot = cogiro();
  robot.cables[2].anchor.x() = nan;
  expectRefused(checkRobot(robot), cable + "anchor is ");
  robot = cogiro();
  robot.cables[2].attachment.y() = 1e7;
  expectRefused(checkRobot(robot), cable + "attachment is ");
  robot = cogiro();
  robot.cables[2].properties.axial_stiffness = 1e300;
  expectRefused(checkRobot(robot), cable + "axial_stiffness is ");
  robot = cogiro();
  robot.cables[2].properties.weight = -1.0;
  expectRefused(checkRobot(robot), cable + "weight is ");
  robot = cogiro();
  robot.cables[2].tension_min = nan;
  expectRefused(checkRobot(robot), cable + "tension_min is ");
}

TEST(RobotChecks, NameEachCoordinateOfAPose) {
  const char* const names[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    Pose pose = cogiro().home;
    EXPECT_TRUE(checkPose("seed", pose).ok());
    pose.position(k) = -2e6;
    expectRefused(checkPose("seed", pose), std::string("seed.position.") + names[k] + " is -2000000 m");
  }
}

TEST(RobotChecks, TakeQuaternionsThatAreNearlyUnit) {
  Pose pose = cogiro().home;
  pose.orientation.coeffs() *= 1.0 + 0.5 * kUnitNorm;
  EXPECT_TRUE(checkPose("pose", pose).ok());
  pose.orientation = Eigen::Quaterniond(1.0 + 5e-4, 0.0, 0.0, 0.0);
  expectRefused(checkPose("pose", pose), "pose.orientation (x, y, z, w) is (0, 0, 0, 1.0005) of norm 1.0005");
  EXPECT_TRUE(checkPose("pose", pose, 1e-3).ok());
}

TEST(RobotChecks, NameEachComponentOfAWrench) {
  const char* const names[] = {"force.x", "force.y", "force.z", "torque.x", "torque.y", "torque.z"};
  for (int k = 0; k < 6; ++k) {
    Wrench wrench = Wrench::Zero();
    EXPECT_TRUE(checkWrench(cogiro(), wrench).ok());
    wrench(k) = 1e13;
    expectRefused(checkWrench(cogiro(), wrench), std::string("external_wrench.") + names[k] + " is 1e+13 N");
  }
}

TEST(RobotChecks, OnlyAPointMassRefusesTorque) {
  Wrench wrench = Wrench::Zero();
  wrench(4) = 2.0;
  EXPECT_TRUE(checkWrench(cogiro(), wrench).ok());
  const RobotDescription point_mass = loadRobotFile(ROBOT_DIR "/paper_point_mass.yaml").robot;
  expectRefused(checkWrench(point_mass, wrench), "external_wrench.torque is (0, 2, 0) N m");
}

TEST(RobotChecks, NameTheEntryAndItsCable) {
  std::vector<double> numbers(8, 10.0);
  EXPECT_TRUE(checkLengths(cogiro(), numbers).ok());
  EXPECT_TRUE(checkPreferredTensions(cogiro(), numbers).ok());
  numbers[6] = 0.0;
  expectRefused(checkLengths(cogiro(), numbers), "lengths[6] of cable 'cable6' is 0 m");
  EXPECT_TRUE(checkPreferredTensions(cogiro(), numbers).ok());
  numbers[6] = -3.0;
  expectRefused(checkPreferredTensions(cogiro(), numbers), "preferred_tensions[6] of cable 'cable6' is -3 N");
}

TEST(RobotChecks, CountEntriesAndNameTheCables) {
  expectRefused(checkLengths(cogiro(), {}), "lengths has 0 entries: expected 8, one for each of cable0, cable1");
  EXPECT_TRUE(checkPreferredTensions(cogiro(), {}).ok());
  const Status status = checkPreferredTensions(cogiro(), {1.0});
  expectRefused(status, "preferred_tensions has 1 entries: expected 8");
  EXPECT_NE(status.message.find("or none for the middle of the limits"), std::string::npos) << status.message;
}

TEST(RobotChecks, OptionsOutOfRange) {
  EXPECT_TRUE(checkRobotOptions({}).ok());
  RobotSolverOptions options;
  options.accuracy = 0.0;
  expectRefused(checkRobotOptions(options), "accuracy is 0 m");
  options = {};
  options.tolerance = 1.0;
  expectRefused(checkRobotOptions(options), "tolerance is 1");
  options = {};
  options.profile_points = 1;
  expectRefused(checkRobotOptions(options), "profile_points is 1");
  options = {};
  options.model = Model::kDefault;
  expectRefused(checkRobotOptions(options), "model is 0");
}

}  // namespace
}  // namespace cdpr_kinetostatics

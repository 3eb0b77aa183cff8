#include "tradeoff/scenario.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {
namespace {

TEST(Scenarios, AreWithinFivePercentOfTheSpanAroundHome) {
  const RobotDescription robot = loadRobotFile(ROBOT_DIR "/desktop_music_wire.yaml").robot;
  const std::vector<Scenario> scenarios = scenariosFor(robot, 3);
  ASSERT_EQ(scenarios.size(), 3u);
  for (const Scenario& scenario : scenarios) {
    ASSERT_TRUE(scenario.reference.report.status.ok());
    const double way = (scenario.request.pose.position - robot.home.position).norm();
    EXPECT_NEAR(way, 0.05 * robot.span(), 1e-12);
    // The pose before lies 10 mm back on the way from home.
    const Eigen::Vector3d back = scenario.reference.pose.position - scenario.previous.pose.position;
    EXPECT_NEAR(back.norm(), 0.01, 1e-9);
    EXPECT_NEAR(back.dot(scenario.request.pose.position - robot.home.position), 0.01 * way, 1e-9);
  }
}

TEST(Scenarios, ARobotThatCannotHoldItsHomeIsNamed) {
  RobotDescription robot = loadRobotFile(ROBOT_DIR "/desktop_music_wire.yaml").robot;
  robot.mass *= 1e9;
  try {
    scenariosFor(robot, 1);
    FAIL() << "the cables hold a thousand million times the platform's mass";
  } catch (const std::runtime_error& problem) {
    EXPECT_NE(std::string(problem.what()).find("robot '" + robot.name + "'"), std::string::npos) << problem.what();
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Forward kinetostatics of platforms that could turn over or that are free to turn: answers known without computing.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/forward_follower.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

CableDescription rope(const std::string& name, const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment) {
  CableDescription cable;
  cable.name = name;
  cable.anchor = anchor;
  cable.attachment = attachment;
  cable.properties.axial_stiffness = 1e5;
  cable.properties.bending_stiffness = 0.01;
  cable.properties.weight = 0.1;
  cable.tension_max = 1e4;
  return cable;
}

// A bar of 1 m on two ropes with its mass above or below it.
RobotDescription barOnTwoRopes(double com) {
  RobotDescription robot;
  robot.mass = 20.0;
  robot.com = {0.0, 0.0, com};
  robot.home.position = {0.0, 0.0, 1.0};
  robot.cables = {rope("left", {-2.0, 0.0, 3.0}, {-0.5, 0.0, 0.0}), rope("right", {2.0, 0.0, 3.0}, {0.5, 0.0, 0.0})};
  return robot;
}

class ForwardStability : public testing::TestWithParam<Model> {
 protected:
  RobotSolution solve(const RobotDescription& robot, const std::vector<double>& lengths) const {
    ForwardRequest request;
    request.lengths = lengths;
    return solveForward(robot, request, patient(GetParam()));
  }
};

INSTANTIATE_TEST_SUITE_P(Models, ForwardStability,
                         testing::Values(Model::kStraight, Model::kStraightElastic, Model::kCatenaryInextensible,
                                         Model::kCatenary, Model::kCatenaryCorrected, Model::kBending, Model::kAuto),
                         [](const auto& model) { return std::string(modelName(model.param)); });

// Upright is an equilibrium, too. From there, exactly, the platform turns over.
TEST_P(ForwardStability, ATopHeavyPlatformHangsUpsideDown) {
  const RobotDescription robot = barOnTwoRopes(0.3);
  const RobotSolution solution = solve(robot, {2.5, 2.5});
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  EXPECT_LT((solution.pose.orientation * robot.com).z(), -0.29);
  const RobotAudit found = audit(robot, Wrench::Zero(), solution);
  EXPECT_LT(found.force, 1e-6);
  EXPECT_LT(found.moment, 1e-6);
}

TEST_P(ForwardStability, APayloadOnOneRopeMayTurnAboutIt) {
  RobotDescription robot;
  robot.mass = 20.0;
  robot.com = {0.0, 0.0, -0.2};
  robot.home.position = {0.3, 0.2, 1.0};
  robot.cables = {rope("rope", {0.0, 0.0, 3.0}, {0.0, 0.0, 0.1})};
  const RobotSolution solution = solve(robot, {2.0});
  if (GetParam() == Model::kCatenaryInextensible) {  // what cannot give has no stiffness to solve with
    EXPECT_EQ(solution.report.status.code, Code::kNotConverged);
    return;
  }
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  EXPECT_NE(solution.report.status.message.find("turns about (0.000, 0.000, "), std::string::npos)
      << solution.report.status.message;
  EXPECT_NEAR(solution.pose.position.z(), 0.9, 0.01);
  EXPECT_NEAR(solution.pose.position.head<2>().norm(), 0.0, 1e-6);
}

// Ropes that are fixed along a line let the platform swing about it, to where its mass hangs below; a mass on the line
// leaves it free.
TEST_P(ForwardStability, AttachmentsInALineLeaveTheTurnAboutItOpen) {
  RobotDescription robot = barOnTwoRopes(0.0);
  const RobotSolution solution = solve(robot, {2.5, 2.5});
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  EXPECT_NE(solution.report.status.message.find("turns about (1.000, 0.000, 0.000)"), std::string::npos)
      << solution.report.status.message;
  const RobotSolution below = solve(barOnTwoRopes(-0.3), {2.5, 2.5});
  ASSERT_TRUE(below.report.status.ok()) << below.report.status.message;
  EXPECT_EQ(below.report.status.message.find("turns about"), std::string::npos) << below.report.status.message;
}

// A path goes on where a freedom is open, and says so at each point.
TEST(ForwardFollowerStability, FollowsAPlatformThatTurnsFreely) {
  const RobotDescription robot = barOnTwoRopes(0.0);
  ForwardFollower follower(robot, patient(Model::kCatenary));
  ForwardRequest request;
  for (int i = 0; i < 20; ++i) {
    request.lengths = {2.5 + 0.002 * i, 2.5 - 0.001 * i};
    ASSERT_TRUE(follower.solve(request).ok()) << i;
    EXPECT_NE(follower.solution().report.status.message.find("turns about"), std::string::npos) << i;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

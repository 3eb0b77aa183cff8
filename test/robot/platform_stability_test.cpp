// Stable, neutral, unstable: platforms whose answer is known without computing, and lengths that are applied.
#include "robot/platform_stability.h"

#include <gtest/gtest.h>

#include <string>

#include "cdpr_kinetostatics/robot/inverse_follower.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

// Four ropes from (+-3, 0, 3) and (0, +-3, 3) to a cross of this half width.
RobotDescription cross(double width, const Eigen::Vector3d& com) {
  RobotDescription robot;
  robot.mass = 10.0;
  robot.com = com;
  robot.home.position = {0.0, 0.0, 1.0};
  for (const Eigen::Vector3d& side : {Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(-1.0, 0.0, 0.0),
                                      Eigen::Vector3d(0.0, 1.0, 0.0), Eigen::Vector3d(0.0, -1.0, 0.0)}) {
    CableDescription cable;
    cable.name = "cable" + std::to_string(robot.cables.size());
    cable.anchor = 3.0 * side + Eigen::Vector3d(0.0, 0.0, 3.0);
    cable.attachment = width * side;
    cable.properties.axial_stiffness = 1e5;
    cable.properties.bending_stiffness = 0.01;
    cable.properties.weight = 0.1;
    cable.tension_min = 1.0;
    cable.tension_max = 500.0;
    robot.cables.push_back(cable);
  }
  return robot;
}

RobotSolution solveAt(const RobotDescription& robot, const Eigen::Vector3d& position, bool free, Model model) {
  InverseRequest request;
  request.pose.position = position;
  request.free_orientation = free;
  return solveInverse(robot, request, patient(model));
}

class InverseStability : public testing::TestWithParam<Model> {};

INSTANTIATE_TEST_SUITE_P(Models, InverseStability,
                         testing::Values(Model::kStraight, Model::kStraightElastic, Model::kCatenary,
                                         Model::kCatenaryInextensible, Model::kBending, Model::kAuto),
                         [](const auto& model) { return std::string(modelName(model.param)); });

TEST_P(InverseStability, ATopHeavyPlatformIsUnstableAndHasItsLengths) {
  const RobotSolution solution = solveAt(cross(0.1, {0.0, 0.0, 0.3}), {0.0, 0.0, 1.0}, false, GetParam());
  EXPECT_EQ(solution.report.status.code, Code::kUnstable) << solution.report.status.message;
  EXPECT_NE(solution.report.status.message.find("the platform would leave this pose: it turns about"),
            std::string::npos)
      << solution.report.status.message;
  ASSERT_EQ(solution.cables.size(), 4U);
  for (const CableResult& cable : solution.cables) EXPECT_NEAR(cable.cable.length, 3.522, 0.002);
}

TEST_P(InverseStability, WithTheMassBelowItIsStable) {
  const RobotSolution solution = solveAt(cross(0.1, {0.0, 0.0, -0.3}), {0.0, 0.0, 1.0}, false, GetParam());
  EXPECT_EQ(solution.report.status.code, Code::kConverged) << solution.report.status.message;
  EXPECT_EQ(solution.report.status.message.find("would leave"), std::string::npos);
}

// A free attitude is one that the platform keeps: its lengths bring it back from a push.
TEST_P(InverseStability, AFreeAttitudeIsStable) {
  const RobotDescription robot = cross(0.1, {0.0, 0.0, 0.3});
  const RobotSolution solution = solveAt(robot, {0.0, 0.0, 1.0}, true, GetParam());
  ASSERT_EQ(solution.report.status.code, Code::kConverged) << solution.report.status.message;
  const Pose pushed = displaced(solution.pose, Eigen::Vector3d::Zero(), {0.05, -0.05, 0.02});
  const RobotSolution back = forward(robot, lengthsOf(solution), pushed, patient(GetParam()));
  ASSERT_TRUE(back.report.status.ok()) << back.report.status.message;
  EXPECT_TRUE(samePose(back.pose, solution.pose, 1e-3));
}

// Ropes that meet in a point leave every turn about it open; a pendulum below that point only the one about itself.
TEST_P(InverseStability, OpenFreedomsAreNamed) {
  const RobotSolution ball = solveAt(cross(0.0, Eigen::Vector3d::Zero()), {0.2, 0.0, 1.0}, false, GetParam());
  EXPECT_EQ(ball.report.status.code, Code::kConverged) << ball.report.status.message;
  EXPECT_NE(ball.report.status.message.find("turns about"), std::string::npos) << ball.report.status.message;
  const RobotSolution pendulum = solveAt(cross(0.0, {0.0, 0.0, -0.2}), {0.2, 0.0, 1.0}, false, GetParam());
  EXPECT_EQ(pendulum.report.status.code, Code::kConverged) << pendulum.report.status.message;
  EXPECT_NE(pendulum.report.status.message.find("turns about (0.000, 0.000, "), std::string::npos)
      << pendulum.report.status.message;
}

TEST(PlatformStability, JudgesByTheSymmetricPart) {
  const RobotDescription robot = cross(0.1, Eigen::Vector3d::Zero());
  LinearRobot::Stiffness stiffness = -1000.0 * LinearRobot::Stiffness::Identity();
  stiffness(0, 4) = 50.0;
  stiffness(4, 0) = -50.0;
  EXPECT_EQ(platformStability(robot, stiffness).kind, Stability::kStable);
  EXPECT_EQ(describeStability(robot, platformStability(robot, stiffness)).message, "");
  stiffness(2, 2) = 0.0;
  const PlatformStability neutral = platformStability(robot, stiffness);
  ASSERT_EQ(neutral.kind, Stability::kNeutral);
  ASSERT_EQ(neutral.motions.size(), 1U);
  EXPECT_NEAR(std::abs(neutral.motions[0](2)), 1.0, 1e-12);
  EXPECT_NE(describeStability(robot, neutral).message.find("moves along"), std::string::npos);
  stiffness(2, 2) = 1.0;
  EXPECT_EQ(platformStability(robot, stiffness).kind, Stability::kUnstable);
  EXPECT_EQ(describeStability(robot, platformStability(robot, stiffness)).code, Code::kUnstable);
}

TEST(PlatformStability, StableMeansThatEveryMotionIsResisted) {
  const RobotDescription rigid = shippedRobot(ROBOT_DIR, "cogiro");
  const RobotDescription point = shippedRobot(ROBOT_DIR, "paper_point_mass");
  LinearRobot::Stiffness stiffness = -LinearRobot::Stiffness::Identity();
  EXPECT_EQ(platformStability(rigid, stiffness).kind, Stability::kStable);
  stiffness(0, 1) = 100.0;  // the part of a torque, which does not count, and
  stiffness(1, 0) = -100.0;
  EXPECT_EQ(platformStability(rigid, stiffness).kind, Stability::kStable);
  stiffness(4, 4) = 0.1;  // a rotation that runs away, which a point mass does not have
  EXPECT_EQ(platformStability(rigid, stiffness).kind, Stability::kUnstable);
  EXPECT_EQ(platformStability(point, stiffness).kind, Stability::kStable);
  stiffness(2, 2) = 0.1;
  EXPECT_EQ(platformStability(point, stiffness).kind, Stability::kUnstable);
}

// Where all ropes meet in the centre of mass nothing resists a turn, on a path as in a first solve.
TEST(PlatformStability, AnOpenFreedomIsFollowedAndNamed) {
  const RobotDescription robot = cross(0.0, Eigen::Vector3d::Zero());
  InverseFollower follower(robot, patient(Model::kCatenary));
  InverseRequest request;
  for (const double x : {0.0, 0.01, 0.02}) {
    request.pose.position = {x, 0.0, 1.0};
    const Status followed = follower.solve(request);
    const Status cold = solveInverse(robot, request, patient(Model::kCatenary)).report.status;
    EXPECT_EQ(followed.code, cold.code);
    EXPECT_EQ(follower.solution().report.status.message, cold.message);
    EXPECT_NE(followed.message.find("a freedom is open"), std::string::npos) << followed.message;
    EXPECT_EQ(follower.warmStarted(), x > 0.0);
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

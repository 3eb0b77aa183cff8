// Inverse kinetostatics with a free attitude: answered from afar, with the heading held, and refused in full sentences.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

double yawOf(const Eigen::Quaterniond& attitude) {
  const Eigen::Matrix3d r = attitude.toRotationMatrix();
  return std::atan2(r(1, 0), r(0, 0));
}

class Scampi : public testing::TestWithParam<Model> {
 protected:
  InverseRequest at(const Eigen::Vector3d& position, const Eigen::Quaterniond& attitude) const {
    InverseRequest request;
    request.free_orientation = true;
    request.pose.position = position;
    request.pose.orientation = attitude;
    return request;
  }

  RobotSolution solve(const InverseRequest& request) const {
    return solveInverse(robot_, request, patient(GetParam(), 1e-10));
  }

  void expectBalance(const RobotSolution& solution) const {
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    const RobotAudit a = audit(robot_, Wrench::Zero(), solution);
    EXPECT_LT(a.force, 1e-8);
    EXPECT_LT(a.moment, 1e-8);
    EXPECT_LT(a.below_limit, 1e-8);
    EXPECT_LT(a.above_limit, 1e-8);
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "scampi");
};

INSTANTIATE_TEST_SUITE_P(Models, Scampi, testing::Values(Model::kCatenary, Model::kBending),
                         [](const auto& model) { return std::string(modelName(model.param)); });

// The attitude that holds is tilted by 40 degrees. Attitude and tensions were found independently for a platform whose
// whole weight of 4.4 kg acts where the file has that of its 2.8 kg.
TEST_P(Scampi, IsHeldFarFromTheAttitudeAskedFor) {
  RobotDescription robot = robot_;
  robot.com *= 4.4 / 2.8;
  const RobotSolution solution =
      solveInverse(robot, at({-1.0, -0.2, 3.3}, Eigen::Quaterniond::Identity()), patient(GetParam(), 1e-10));
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  EXPECT_LT(audit(robot, Wrench::Zero(), solution).moment, 1e-8);
  EXPECT_LT(solution.pose.orientation.angularDistance(Eigen::Quaterniond(0.9425, 0.053, 0.330, 0.0).normalized()),
            0.01);
  const double expected[] = {26.5, 6.4, 7.3, 32.6};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(tensionsOf(solution)[i], expected[i], 0.1);
}

// What is reached in small steps from home, carrying the attitude along, is reached at once.
TEST_P(Scampi, EveryPositionOnAPathFromHomeIsAnsweredFromAnyAttitude) {
  Dice dice(97);
  for (int k = 0; k < 6; ++k) {
    const Eigen::Vector3d goal = dice.inBox({-1.4, -7.0, 2.0}, {2.0, 3.5, 4.0});
    Eigen::Quaterniond attitude = robot_.home.orientation;
    bool reached = true;
    for (int i = 0; i <= 20 && reached; ++i) {
      const RobotSolution on_path =
          solve(at(robot_.home.position + i / 20.0 * (goal - robot_.home.position), attitude));
      reached = on_path.report.status.ok();
      attitude = on_path.pose.orientation;
    }
    if (!reached) continue;
    for (const double angle : {0.0, 0.3, 0.6}) {
      SCOPED_TRACE(testing::Message() << goal.transpose() << ", " << angle);
      expectBalance(solve(at(goal, Eigen::Quaterniond(Eigen::AngleAxisd(angle, dice.direction())))));
    }
  }
}

// A plane of positions, each reached from its neighbour by carrying the attitude along: wherever one is held, it is
// answered from a level platform.
TEST(FreeOrientation, EveryPositionOfAPlaneThatIsReachedStepByStepIsAnsweredFromLevel) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "scampi");
  const RobotSolverOptions options = patient(Model::kCatenary);
  InverseRequest request;
  request.free_orientation = true;
  int reached = 0;
  for (int column = 0; column < 14; ++column) {
    const double x = 0.36 + 0.3 * (column - 6.5);
    for (const double step : {0.9, -0.9}) {
      // Along the row from the middle, until no attitude holds the position.
      Eigen::Quaterniond carried = Eigen::Quaterniond::Identity();
      for (double y = step > 0.0 ? -1.77 : -1.77 + step; std::abs(y + 1.77) < 6.0; y += step) {
        request.pose.position = {x, y, 3.0};
        request.pose.orientation = carried;
        const RobotSolution neighbour = solveInverse(robot, request, options);
        request.pose.orientation.setIdentity();
        const RobotSolution level = solveInverse(robot, request, options);
        EXPECT_EQ(level.report.status.ok(), neighbour.report.status.ok())
            << request.pose.position.transpose() << ": " << level.report.status.message;
        if (!neighbour.report.status.ok()) break;
        carried = neighbour.pose.orientation;
        ++reached;
      }
    }
  }
  EXPECT_GT(reached, 100);
}

// Top-heavy platforms on three to five cables hang upside down, or as near to it as their cables let them.
TEST(FreeOrientation, TopHeavyPlatformsOnFewCablesAreAnsweredStable) {
  Dice dice(96);
  const RobotSolverOptions options = patient(Model::kCatenary);
  for (int k = 0; k < 30; ++k) {
    SCOPED_TRACE(k);
    RobotDescription robot;
    robot.mass = dice.uniform(2.0, 50.0);
    robot.com = {0.0, 0.0, dice.uniform(0.02, 0.3)};
    const int count = 3 + k % 3;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * M_PI * (i + dice.uniform(-0.2, 0.2)) / count;
      CableDescription cable;
      cable.name = "cable" + std::to_string(i);
      cable.anchor = {4.0 * std::cos(angle), 4.0 * std::sin(angle), dice.uniform(3.5, 4.5)};
      cable.attachment = {0.2 * std::cos(angle), 0.2 * std::sin(angle), 0.0};
      cable.properties.axial_stiffness = 2e5;
      cable.properties.weight = 0.3;
      cable.tension_min = 0.0;
      cable.tension_max = 4.0 * robot.weight();
      robot.cables.push_back(cable);
    }
    robot.home.position = {0.0, 0.0, 1.0};
    InverseRequest request;
    request.free_orientation = true;
    request.pose.position = {dice.uniform(-0.5, 0.5), dice.uniform(-0.5, 0.5), dice.uniform(0.5, 1.5)};
    const RobotSolution solution = solveInverse(robot, request, options);
    ASSERT_EQ(solution.report.status.code, Code::kConverged) << solution.report.status.message;
    const RobotAudit a = audit(robot, Wrench::Zero(), solution);
    EXPECT_LT(a.force, 1e-8);
    EXPECT_LT(a.moment, 1e-8);
    EXPECT_LT(largestStiffness(robot, solution, Model::kCatenary), 0.0) << "it would leave that pose";
  }
}

TEST_P(Scampi, TheHeadingIsHeld) {
  Dice dice(98);
  for (int k = 0; k < 10; ++k) {
    const double yaw = dice.uniform(-0.15, 0.15);
    const Eigen::Quaterniond seed = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(dice.uniform(-0.3, 0.3), Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(dice.uniform(-0.3, 0.3), Eigen::Vector3d::UnitX());
    InverseRequest request = at(dice.inBox({-0.5, -4.0, 2.0}, {1.0, 0.5, 4.0}), seed);
    request.hold_yaw = true;
    const RobotSolution solution = solve(request);
    SCOPED_TRACE(k);
    expectBalance(solution);
    EXPECT_NEAR(yawOf(solution.pose.orientation), yaw, 1e-9);
  }
}

// Lengths to pose to lengths: four cables at a heading have no choice.
TEST_P(Scampi, LengthsComeBackThroughPositionAndHeading) {
  Dice dice(99);
  for (int k = 0; k < 6; ++k) {
    const RobotSolution start =
        solve(at(dice.inBox({-0.5, -4.0, 2.0}, {1.0, 0.5, 4.0}), Eigen::Quaterniond::Identity()));
    ASSERT_TRUE(start.report.status.ok()) << start.report.status.message;
    std::vector<double> lengths = lengthsOf(start);
    for (double& length : lengths) length += dice.uniform(-0.02, 0.02);
    const RobotSolution pose = forward(robot_, lengths, start.pose, patient(GetParam(), 1e-10));
    ASSERT_TRUE(pose.report.status.ok()) << pose.report.status.message;
    const Eigen::AngleAxisd heading(yawOf(pose.pose.orientation), Eigen::Vector3d::UnitZ());
    InverseRequest request = at(pose.pose.position, Eigen::Quaterniond(heading));
    request.hold_yaw = true;
    const RobotSolution back = solve(request);
    ASSERT_TRUE(back.report.status.ok()) << back.report.status.message;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(lengthsOf(back)[i], lengths[i], 1e-7) << k << " " << i;
  }
}

TEST(FreeOrientation, ThreeCablesCannotHoldAHeading) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "scampi");
  robot.cables.pop_back();
  InverseRequest request;
  request.pose = robot.home;
  request.free_orientation = request.hold_yaw = true;
  const RobotSolution refused = solveInverse(robot, request, patient(Model::kCatenary));
  EXPECT_EQ(refused.report.status.code, Code::kInvalidInput);
  EXPECT_NE(refused.report.status.message.find("hold_yaw is true: expected false for scampi, which has 3 cables"),
            std::string::npos);
}

TEST(FreeOrientation, ARefusalSpeaksOfAttitudesAndLeavesNothingOpen) {
  InverseRequest request;
  request.free_orientation = true;
  request.pose.position = {6.0, 0.0, 3.0};  // outside the anchors
  const RobotSolution refused = solveInverse(shippedRobot(ROBOT_DIR, "scampi"), request, patient(Model::kCatenary));
  const std::string& text = refused.report.status.message;
  EXPECT_EQ(refused.report.status.code, Code::kInfeasible) << text;
  EXPECT_EQ(text.find("no attitude was found that holds this position"), 0U) << text;
  EXPECT_NE(text.back(), ':') << text;
}

}  // namespace
}  // namespace cdpr_kinetostatics

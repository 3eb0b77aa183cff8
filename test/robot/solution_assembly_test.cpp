#include "robot/solution_assembly.h"

#include <gtest/gtest.h>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

CableSolution pulled(double length, double x, double y, double h, double v) {
  CableSolution cable;
  cable.length = length;
  cable.x = x;
  cable.y = y;
  cable.horizontal_force = h;
  cable.vertical_force_a = v;
  cable.tension_a = std::hypot(h, v);
  return cable;
}

TEST(SolutionAssembly, ConditionsOfACable) {
  EXPECT_EQ(conditionOf(pulled(5.0, 3.0, 4.0, 30.0, 40.0), 20.0), Condition::kTaut);
  EXPECT_EQ(conditionOf(pulled(5.3, 3.0, 4.0, 30.0, 40.0), 20.0), Condition::kSlack) << "6 % longer than its chord";
  EXPECT_EQ(conditionOf(pulled(5.0, 3.0, 4.0, 30.0, 40.0), 60.0), Condition::kSlack) << "50 N of at least 60 N";
  EXPECT_EQ(conditionOf(pulled(5.0, 3.0, 4.0, 30.0, 40.0), 50.0), Condition::kTaut) << "on its limit";
  EXPECT_EQ(conditionOf(pulled(5.3, 3.0, 4.0, -30.0, 40.0), 20.0), Condition::kCompressed);
}

TEST(SolutionAssembly, ARefusalHasNothingButItsReason) {
  const RobotSolution refused = refusedRobot(Model::kCatenary, {Code::kInfeasible, "too heavy"});
  EXPECT_EQ(refused.report.status.code, Code::kInfeasible);
  EXPECT_EQ(refused.report.status.message, "too heavy");
  EXPECT_EQ(refused.report.model, Model::kCatenary);
  EXPECT_TRUE(refused.cables.empty());
}

TEST(SolutionAssembly, ResidualsAreSummedAnewFromTheCables) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  const RobotSolution solved = solveInverse(robot, requestFor(robot, robot.home), patient(Model::kCatenary));
  ASSERT_TRUE(solved.report.status.ok());
  std::vector<CableSolution> cables;
  for (const CableResult& result : solved.cables) cables.push_back(result.cable);

  // What one cable pulls more at its end is what the balance misses, and its moment about the platform's origin.
  const double extra = 7.0;  // [N], of cable 2, horizontally
  cables[2].horizontal_force += extra;
  cables[4].closure_residual = 0.125;
  RobotSolution assembled;
  assembled.pose = solved.pose;
  assemble(robot, Wrench::Zero(), cables, &assembled);
  EXPECT_NEAR(assembled.report.force_residual, extra, 1e-4);
  const Eigen::Vector3d arm = robot.home.orientation * robot.cables[2].attachment;
  const Eigen::Vector3d pull = -extra * solved.cables[2].direction;
  EXPECT_NEAR(assembled.report.moment_residual, arm.cross(pull).norm(), 1e-4);
  EXPECT_EQ(assembled.report.closure_residual, 0.125);
  EXPECT_EQ(assembled.cables[2].name, robot.cables[2].name);
}

}  // namespace
}  // namespace cdpr_kinetostatics

#include "robot/solution_assembly.h"

#include <gtest/gtest.h>

#include "robot_audit.h"
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
  cable.free_length = length;
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

TEST(SolutionAssembly, ResidualsAreThoseOfAnIndependentSum) {
  for (const char* name : {"cogiro", "paper_point_mass"}) {
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    RobotSolution at = solveInverse(robot, requestFor(robot, robot.home), patient(Model::kCatenary));
    ASSERT_TRUE(at.report.status.ok());
    std::vector<CableSolution> cables;
    std::vector<PlaneForces> forces;
    for (const CableResult& result : at.cables) {
      cables.push_back(result.cable);
      cables.back().horizontal_force *= 1.01;  // no longer in balance
      forces.push_back({cables.back().horizontal_force, cables.back().vertical_force_a, cables.back().length});
    }
    cables.front().closure_residual = 0.02;
    Wrench external = Wrench::Zero();
    external.z() = 3.0;
    const Wrench total = totalWrench(robot, external, at.pose, forces);
    RobotSolution solution;
    solution.pose = at.pose;
    assemble(robot, external, cables, &solution);
    EXPECT_EQ(solution.report.closure_residual, 0.02);
    EXPECT_NEAR(solution.report.force_residual, total.head<3>().norm(), 1e-9 * robot.weight());
    EXPECT_NEAR(solution.report.moment_residual, robot.freedoms() == 6 ? total.tail<3>().norm() : 0.0,
                1e-9 * robot.weight());
    EXPECT_EQ(solution.report.model, Model::kCatenary);
    Wrench by_cables = Wrench::Zero();
    for (std::size_t i = 0; i < cables.size(); ++i) {
      EXPECT_EQ(solution.cables[i].name, robot.cables[i].name);
      by_cables.head<3>() += solution.cables[i].force_on_platform;
    }
    EXPECT_NEAR(by_cables.z() + external.z() - robot.weight(), total.z(), 1e-9 * robot.weight());
  }
}

TEST(SolutionAssembly, ProfilesRunFromTheAnchorToTheAttachment) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  RobotSolverOptions options = patient(Model::kCatenary, 1e-11);
  options.profile_points = 5;
  const RobotSolution at = solveInverse(robot, requestFor(robot, robot.home), options);
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    ASSERT_EQ(at.cables[i].profile.size(), 5U);
    EXPECT_LT((at.cables[i].profile.front() - robot.cables[i].anchor).norm(), 1e-9);
    const Eigen::Vector3d b = attachmentInWorld(at.pose, robot.cables[i].attachment);
    EXPECT_LT((at.cables[i].profile.back() - b).norm(), 1e-6);
  }
}

TEST(SolutionAssembly, AFailureCarriesWhatTheSearchHadReached) {
  SearchOutcome outcome;
  outcome.status = {Code::kNotConverged, "why"};
  outcome.iterations = 7;
  outcome.residuals = {0.1, 0.2, 0.3};
  const RobotSolution refused = failedRobot(Model::kBending, outcome);
  EXPECT_EQ(refused.report.status.code, Code::kNotConverged);
  EXPECT_EQ(refused.report.status.message, "why");
  EXPECT_EQ(refused.report.model, Model::kBending);
  EXPECT_EQ(refused.report.iterations, 7);
  EXPECT_EQ(refused.report.closure_residual, 0.1);
  EXPECT_EQ(refused.report.force_residual, 0.2);
  EXPECT_EQ(refused.report.moment_residual, 0.3);
  EXPECT_TRUE(refused.cables.empty());
}

}  // namespace
}  // namespace cdpr_kinetostatics

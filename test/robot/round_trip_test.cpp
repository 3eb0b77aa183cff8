// Forward kinetostatics undoes inverse kinetostatics: 200 random feasible poses of every shipped robot.
#include <gtest/gtest.h>

#include <iostream>
#include <tuple>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kPoses = 200;
constexpr int kMaxTries = 2000;
constexpr double kPoseTolerance = 1e-6;   // [m], [rad]
constexpr double kBalance = 1e-9;         // of the platform's weight
constexpr double kClosure = 1e-8;         // of the robot's span
constexpr double kLimit = 1e-6;           // relative excess over a limit of T_A
constexpr double kShareElsewhere = 0.01;  // of answers that are another equilibrium
constexpr double kSeedShareOfSpan = 0.03;
constexpr double kSeedAngle = 0.1;  // [rad]

class RoundTrip : public testing::TestWithParam<std::tuple<Workspace, Model>> {};

void expectEquilibrium(const RobotDescription& robot, const RobotSolution& solution) {
  const RobotAudit a = audit(robot, Wrench::Zero(), solution);
  EXPECT_LT(a.force, kBalance);
  EXPECT_LT(a.moment, kBalance);
  EXPECT_LT(a.closure, kClosure * robot.span());
}

// A tension that a taut cable has, a long loop between the same ends has too: the short one is meant.
void expectShortestCables(const RobotDescription& robot, const RobotSolution& solution) {
  CableSolverOptions options;
  options.model = Model::kCatenary;
  options.tolerance = 1e-6;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CableSolution& cable = solution.cables[i].cable;
    const CableSolution shortest =
        findLength(robot.cables[i].properties, cable.x, cable.y, cable.tension_a, 0.0, options);
    if (!shortest.status.ok()) continue;  // at the least tension that can hold the cable
    EXPECT_LT(cable.length, 1.05 * shortest.length) << "cable " << i << ", tension " << cable.tension_a << " N";
  }
}

TEST_P(RoundTrip, ForwardOfInverseIsThePose) {
  const Workspace& workspace = std::get<0>(GetParam());
  const Model model = std::get<1>(GetParam());
  const RobotDescription robot = shippedRobot(ROBOT_DIR, workspace.robot);
  const RobotSolverOptions options = patient(model);
  Dice dice(20240301);
  Dice seeds(6);
  int feasible = 0;
  int tried = 0;
  int elsewhere = 0;
  for (; feasible < kPoses && tried < kMaxTries; ++tried) {
    const Pose pose = randomPose(workspace, &dice);
    const RobotSolution inverse = solveInverse(robot, requestFor(robot, pose), options);
    if (inverse.report.status.code == Code::kInfeasible) continue;
    SCOPED_TRACE(testing::Message() << "pose " << tried << " at " << pose.position.transpose() << ", attitude "
                                    << pose.orientation.coeffs().transpose());
    ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    ++feasible;
    expectEquilibrium(robot, inverse);
    const RobotAudit limits = audit(robot, Wrench::Zero(), inverse);
    EXPECT_LT(limits.below_limit, kLimit);
    EXPECT_LT(limits.above_limit, kLimit);
    expectShortestCables(robot, inverse);

    ForwardRequest request;
    request.lengths = lengthsOf(inverse);
    request.seed = seeds.away(inverse.pose, kSeedShareOfSpan * robot.span(), kSeedAngle);
    if (robot.type == PlatformType::kPointMass) request.seed->orientation = inverse.pose.orientation;
    const RobotSolution forward = solveForward(robot, request, options);
    ASSERT_TRUE(forward.report.status.ok()) << forward.report.status.message;
    expectEquilibrium(robot, forward);
    if (!samePose(forward.pose, inverse.pose, kPoseTolerance)) {
      ++elsewhere;
      std::cout << "another equilibrium, " << (forward.pose.position - inverse.pose.position).norm() << " m and "
                << forward.pose.orientation.angularDistance(inverse.pose.orientation) << " rad from pose " << tried
                << "\n";
    }
  }
  EXPECT_EQ(feasible, kPoses) << "of " << tried << " poses";
  EXPECT_LE(elsewhere, kShareElsewhere * feasible);
  RecordProperty("tried", tried);
  RecordProperty("elsewhere", elsewhere);
}

// Every cable's shape, integrated piece by piece by an independent integrator, leads to its attachment.
TEST_P(RoundTrip, ShapesObeyTheCableEquations) {
  const Workspace& workspace = std::get<0>(GetParam());
  const Model model = std::get<1>(GetParam());
  if (!isBending(model)) GTEST_SKIP() << "catenaries have a formula";
  const RobotDescription robot = shippedRobot(ROBOT_DIR, workspace.robot);
  RobotSolverOptions options = patient(model, 1e-10);
  options.profile_points = 400;
  Dice dice(5);
  int feasible = 0;
  for (int tried = 0; feasible < 5 && tried < kMaxTries; ++tried) {
    const Pose pose = randomPose(workspace, &dice);
    const RobotSolution inverse = solveInverse(robot, requestFor(robot, pose), options);
    if (inverse.report.status.code == Code::kInfeasible) continue;
    ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    ++feasible;
    EXPECT_LT(largestProfileDefect(robot, inverse, 32), 1e-9 * robot.span()) << "pose " << tried;
  }
  EXPECT_EQ(feasible, 5);
}

INSTANTIATE_TEST_SUITE_P(All, RoundTrip,
                         testing::Combine(testing::ValuesIn(shippedWorkspaces()),
                                          testing::Values(Model::kCatenary, Model::kBending)),
                         [](const testing::TestParamInfo<std::tuple<Workspace, Model>>& each) {
                           return std::get<0>(each.param).robot + "_" + modelName(std::get<1>(each.param));
                         });

}  // namespace
}  // namespace cdpr_kinetostatics

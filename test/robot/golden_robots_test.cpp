// Whole robots against an independent solver's reference values (test/golden/README.md).
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"
#include "robot_golden.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kPoseTolerance = 1e-7;    // [m], [rad]
constexpr double kForceTolerance = 1e-6;   // relative to the tension
constexpr double kLengthTolerance = 1e-7;  // relative

class GoldenRobots : public testing::TestWithParam<std::tuple<GoldenRobot, Model>> {
 protected:
  const GoldenRobot& golden() const { return std::get<0>(GetParam()); }
  Model model() const { return std::get<1>(GetParam()); }
  const GoldenRobot::Answer& answer() const { return golden().answer(model()); }

  RobotSolution forwardFrom(const Pose& seed) const {
    ForwardRequest request;
    request.lengths = answer().length;
    request.external_wrench = golden().external_wrench;
    request.seed = seed;
    return solveForward(golden().robot, request, patient(model(), 1e-9));
  }

  void expectReference(const RobotSolution& solution) const {
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    EXPECT_LT((solution.pose.position - golden().pose.position).norm(), kPoseTolerance);
    EXPECT_LT(solution.pose.orientation.angularDistance(golden().pose.orientation), kPoseTolerance);
    expectForces(solution);
  }

  void expectForces(const RobotSolution& solution) const {
    for (std::size_t i = 0; i < solution.cables.size(); ++i) {
      const CableSolution& cable = solution.cables[i].cable;
      const double tolerance = kForceTolerance * answer().tension[i];
      EXPECT_NEAR(cable.horizontal_force, answer().h[i], tolerance) << "cable " << i;
      EXPECT_NEAR(cable.vertical_force_a, answer().v[i], tolerance) << "cable " << i;
    }
  }
};

TEST_P(GoldenRobots, ForwardFromTheMiddleOfTheAnchorsReachesTheReference) {
  Pose seed;
  for (const CableDescription& cable : golden().robot.cables) seed.position += cable.anchor;
  seed.position /= static_cast<double>(golden().robot.cables.size());
  seed.position.z() = golden().pose.position.z();
  expectReference(forwardFrom(seed));
}

TEST_P(GoldenRobots, ForwardFromSeedsAroundReachesTheReference) {
  Dice dice(7);
  const double distance = golden().robot.span() < 2.0 ? 0.03 : 0.3;
  for (int i = 0; i < 10; ++i) {
    SCOPED_TRACE("seed " + std::to_string(i));
    Pose seed = dice.away(golden().pose, distance, 0.1);
    if (golden().robot.type == PlatformType::kPointMass) seed.orientation = golden().pose.orientation;
    expectReference(forwardFrom(seed));
  }
}

TEST_P(GoldenRobots, InverseWithTheReferenceTensionsGivesItsLengths) {
  InverseRequest request;
  request.pose = golden().pose;
  request.external_wrench = golden().external_wrench;
  request.preferred_tensions = answer().tension;
  const RobotSolution solution = solveInverse(golden().robot, request, patient(model(), 1e-9));
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  for (std::size_t i = 0; i < solution.cables.size(); ++i) {
    EXPECT_NEAR(solution.cables[i].cable.length / answer().length[i], 1.0, kLengthTolerance) << "cable " << i;
  }
  expectForces(solution);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenRobots,
                         testing::Combine(testing::ValuesIn(goldenRobots(TEST_DATA_DIR)),
                                          testing::Values(Model::kCatenary, Model::kBending)),
                         [](const testing::TestParamInfo<std::tuple<GoldenRobot, Model>>& each) {
                           return std::get<0>(each.param).robot.name + "_" + modelName(std::get<1>(each.param));
                         });

}  // namespace
}  // namespace cdpr_kinetostatics

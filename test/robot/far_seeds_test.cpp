// Cold solves from far away: seeds within 1 m and 0.5 rad of the pose.
#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kDistance = 1.0;  // [m]
constexpr double kAngle = 0.5;     // [rad]
constexpr double kShare = 0.99;
constexpr double kPoseTolerance = 1e-6;  // [m], [rad]
// Of AUTO: inverse and forward solution are each this near to BENDING's, the angle where the radius is 1 m.
constexpr double kAccuracy = 1e-4;  // [m]

struct FarSeeds {
  std::string robot;
  Model model;
  int solves;
};

class FarSeed : public testing::TestWithParam<FarSeeds> {};

TEST_P(FarSeed, LeadsToTheRightPose) {
  const Workspace workspace = workspaceOf(GetParam().robot);
  const RobotDescription robot = shippedRobot(ROBOT_DIR, GetParam().robot);
  const RobotSolverOptions options = patient(GetParam().model);
  const double tolerance =
      GetParam().model == Model::kAuto ? 2.0 * kAccuracy / std::min(1.0, robot.platformRadius()) : kPoseTolerance;
  Dice dice(77);
  int solved = 0;
  int right = 0;
  int refused = 0;
  while (solved < GetParam().solves) {
    const RobotSolution inverse = solveInverse(robot, requestFor(robot, randomPose(workspace, &dice)), options);
    if (inverse.report.status.code == Code::kInfeasible) continue;
    ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    ++solved;
    ForwardRequest request;
    request.lengths = lengthsOf(inverse);
    request.seed = dice.away(inverse.pose, dice.uniform(0.0, kDistance), dice.uniform(0.0, kAngle));
    const RobotSolution forward = solveForward(robot, request, options);
    ASSERT_TRUE(isFinite(forward));
    const Status& status = forward.report.status;
    if (!status.ok()) {
      ++refused;
      EXPECT_FALSE(status.message.empty());
      std::cout << "solve " << solved << ": " << status.message << "\n";
    } else if (samePose(forward.pose, inverse.pose, tolerance)) {
      ++right;
    } else {
      std::cout << "solve " << solved << ": another equilibrium, "
                << (forward.pose.position - inverse.pose.position).norm() << " m and "
                << forward.pose.orientation.angularDistance(inverse.pose.orientation) << " rad away\n";
    }
  }
  std::cout << GetParam().robot << ", " << modelName(GetParam().model) << ": right pose in " << right << " of "
            << solved << " cold solves, refused " << refused << "\n";
  EXPECT_GE(right, kShare * solved);
}

INSTANTIATE_TEST_SUITE_P(
    All, FarSeed,
    testing::Values(FarSeeds{"cogiro", Model::kCatenary, 500}, FarSeeds{"cogiro", Model::kAuto, 500},
                    FarSeeds{"cogiro", Model::kBending, 200}, FarSeeds{"caroca", Model::kCatenary, 500},
                    FarSeeds{"caroca", Model::kAuto, 500}, FarSeeds{"caroca", Model::kBending, 200},
                    FarSeeds{"ipanema3", Model::kCatenary, 500}, FarSeeds{"ipanema3", Model::kAuto, 500},
                    FarSeeds{"ipanema3", Model::kBending, 200}),
    [](const testing::TestParamInfo<FarSeeds>& each) { return each.param.robot + "_" + modelName(each.param.model); });

}  // namespace
}  // namespace cdpr_kinetostatics

// What the cables' models leave out, at the platform: equation (37) with the cables solved by BENDING.
#include "robot/platform_error.h"

#include <gtest/gtest.h>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

RobotSolution solvedAtHome(const RobotDescription& robot, Model model) {
  const RobotSolution inverse = solveInverse(robot, requestFor(robot, robot.home), patient(Model::kBending, 1e-11));
  EXPECT_TRUE(inverse.report.status.ok());
  return forward(robot, lengthsOf(inverse), inverse.pose, patient(model, 1e-11));
}

std::vector<CableSolution> cablesOf(const RobotSolution& solution) {
  std::vector<CableSolution> cables;
  for (const CableResult& result : solution.cables) cables.push_back(result.cable);
  return cables;
}

TEST(PlatformError, IsTheWayToThePoseOfTheFinestModel) {
  for (const char* name : {"cogiro", "ipanema3", "scampi"}) {
    SCOPED_TRACE(name);
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    const RobotSolution fine = solvedAtHome(robot, Model::kBending);
    const RobotSolution coarse = solvedAtHome(robot, Model::kCatenary);
    ASSERT_TRUE(fine.report.status.ok() && coarse.report.status.ok());
    const PlatformError error = platformError(robot, coarse.pose, cablesOf(coarse));
    const double apart = (coarse.pose.position - fine.pose.position).norm();
    EXPECT_TRUE(error.known);
    EXPECT_NEAR(error.translation, apart, 0.1 * apart);
    const double turned = coarse.pose.orientation.angularDistance(fine.pose.orientation);
    EXPECT_NEAR(error.rotation, turned, 0.1 * turned + 1e-9);
    EXPECT_EQ(error.cables.size(), robot.cables.size());
    EXPECT_EQ(platformError(robot, fine.pose, cablesOf(fine)).translation, 0.0);
  }
}

TEST(PlatformError, WithinTheAccuracyMeansKnownAndWithSomethingInHand) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  RobotSolution solution = solvedAtHome(robot, Model::kCatenary);
  solution.report.estimated_rotation_error = 0.0;
  solution.report.estimated_error = 0.7e-4;
  EXPECT_TRUE(isWithin(robot, solution, 1e-4));
  solution.report.estimated_error = 0.8e-4;
  EXPECT_FALSE(isWithin(robot, solution, 1e-4));
  solution.report.estimated_error = 0.5e-4;
  solution.report.estimated_rotation_error = 0.8e-4 / robot.lever();
  EXPECT_FALSE(isWithin(robot, solution, 1e-4)) << "rotations count at the lever";
  solution.report.estimated_rotation_error = 0.0;
  solution.cables[3].cable.model = Model::kStraightElastic;
  EXPECT_FALSE(isWithin(robot, solution, 1e-4)) << "lines need more in hand";
  solution.report.estimated_error = 0.0;
  solution.report.error_known = false;
  EXPECT_FALSE(isWithin(robot, solution, 1e-4));
}

TEST(PlatformError, TheChoiceIsCountedAndItsErrorNamed) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  RobotSolution solution = solvedAtHome(robot, Model::kCatenary);
  solution.cables[0].cable.model = Model::kBending;
  solution.report.estimated_error = 1.2e-5;
  EXPECT_EQ(describeChoice(solution),
            "catenary for 7 cables, bending for 1 cable; what this neglects moves the platform by 1.2e-05 m");
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The straight rope around a pulley: against geometry written out here, and against what single cables say.
#include "robot/straight_rope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "robot/platform_statics.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

CableProperties onPulley(double radius, RopeFrom from) {
  CableProperties cable;
  cable.axial_stiffness = 2.87e5;
  cable.weight = 0.628;
  cable.pulley = {radius, from};
  return cable;
}

TEST(StraightRope, WithoutAPulleyItIsTheChord) {
  const StraightRope rope = straightRope(onPulley(0.0, RopeFrom::kBelow), 3.0, -4.0);
  EXPECT_EQ(rope.free, Eigen::Vector2d(3.0, -4.0));
  EXPECT_EQ(rope.wrapped, 0.0);
  EXPECT_EQ(rope.length(), 5.0);
}

// The free part is a tangent: it ends at B, begins on the circle, and is at right angles to the radius there.
TEST(StraightRope, LeavesThePulleyAlongItsTangent) {
  const double r = 0.3;
  for (const RopeFrom from : {RopeFrom::kBelow, RopeFrom::kAbove}) {
    for (const double y : {-4.0, -0.5, 0.0, 2.0}) {
      const StraightRope rope = straightRope(onPulley(r, from), 3.0, y);
      const Eigen::Vector2d radius = Eigen::Vector2d(3.0, y) - rope.free - Eigen::Vector2d(r, 0.0);
      EXPECT_NEAR(radius.norm(), r, 1e-14);
      EXPECT_NEAR(radius.dot(rope.free), 0.0, 1e-14);
      // From A0, at the angle pi about the centre, clockwise over the top or anticlockwise under the bottom.
      const double at = std::atan2(radius.y(), radius.x());
      const double turned = from == RopeFrom::kBelow ? M_PI - at : M_PI + at;
      EXPECT_NEAR(rope.wrapped, r * turned, 1e-14);
    }
  }
}

TEST(StraightRope, APointWithinThePulleyIsTakenAsWithoutOne) {
  const StraightRope rope = straightRope(onPulley(0.3, RopeFrom::kBelow), 0.3, 0.1);
  EXPECT_EQ(rope.free, Eigen::Vector2d(0.3, 0.1));
}

TEST(StraightRope, PlacesThatARopeCannotReachNameTheCable) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  EXPECT_TRUE(checkPulleys(robot, robot.home).ok());
  robot.cables[3].properties.pulley.radius = 10.0;
  const Status status = checkPulleys(robot, robot.home);
  EXPECT_EQ(status.code, Code::kInfeasible);
  EXPECT_NE(status.message.find("cable 'cable3'"), std::string::npos) << status.message;
}

TEST(StraightRope, ForcesTellWhereTheRopeLeavesAndHowMuchHangs) {
  CableProperties cable = onPulley(0.05, RopeFrom::kBelow);
  cable.dead_length = 12.0;
  CableSolverOptions options;
  options.model = Model::kCatenary;
  const CableSolution solved = findForces(cable, 9.0, 8.0, -4.0, options);
  ASSERT_TRUE(solved.status.ok()) << solved.status.message;
  const ForcesAtA forces{solved.horizontal_force, solved.vertical_force_a};
  EXPECT_NEAR(freeLengthUnder(cable, 9.0, forces), solved.free_length, 1e-12);
  EXPECT_NEAR(departureUnder(cable, forces).x(), solved.departure_x, 1e-12);
  EXPECT_NEAR(departureUnder(cable, forces).y(), solved.departure_y, 1e-12);
  cable.bending_stiffness = 0.16;  // to first order
  options.model = Model::kBending;
  const CableSolution bent = findForces(cable, 9.0, 8.0, -4.0, options);
  ASSERT_TRUE(bent.status.ok()) << bent.status.message;
  EXPECT_NEAR(freeLengthUnder(cable, 9.0, {bent.horizontal_force, bent.vertical_force_a}), bent.free_length, 2e-3);
}

TEST(StraightRope, ForcesAtBAreThoseAtAWithoutAPulley) {
  SaggingCable cable(onPulley(0.0, RopeFrom::kBelow), Model::kCatenary, 1e-8);
  cable.start(9.0, {300.0, 150.0});
  ASSERT_TRUE(cable.linearise(true));
  EXPECT_EQ(forcesAtB(cable), Eigen::Matrix2d::Identity());
}

TEST(StraightRope, ForcesAtBFollowThoseAtAByDifferences) {
  const CableProperties properties = onPulley(0.5, RopeFrom::kBelow);
  const auto atB = [&](double h, double v) {
    SaggingCable cable(properties, Model::kCatenary, 1e-8);
    cable.start(9.0, {h, v});
    EXPECT_TRUE(cable.linearise(true));
    return cable.verticalForceB();
  };
  SaggingCable cable(properties, Model::kCatenary, 1e-8);
  cable.start(9.0, {30.0, 15.0});
  ASSERT_TRUE(cable.linearise(true));
  const double step = 1e-4;
  EXPECT_NEAR(forcesAtB(cable)(1, 0), (atB(30.0 + step, 15.0) - atB(30.0 - step, 15.0)) / (2.0 * step), 1e-9);
  EXPECT_NEAR(forcesAtB(cable)(1, 1), (atB(30.0, 15.0 + step) - atB(30.0, 15.0 - step)) / (2.0 * step), 1e-9);
}

}  // namespace
}  // namespace cdpr_kinetostatics

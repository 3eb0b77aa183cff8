// The free attitude's changes against differences, and the heading that is held.
#include "robot/free_attitude.h"

#include <gtest/gtest.h>

#include "geometry/spatial.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

FreeAttitude attitudeOf(bool hold_yaw, const Eigen::Quaterniond& asked) {
  InverseRequest request;
  request.free_orientation = true;
  request.hold_yaw = hold_yaw;
  request.pose.orientation = asked;
  return {shippedRobot(ROBOT_DIR, "scampi"), request};
}

class FreeAttitudes : public testing::TestWithParam<bool> {};

TEST_P(FreeAttitudes, AxesAreTheDerivativeOfTheTurn) {
  Dice dice(95);
  for (int i = 0; i < 20; ++i) {
    Pose pose;
    pose.orientation = Eigen::AngleAxisd(dice.uniform(0.0, 0.8), dice.direction());
    const FreeAttitude attitude = attitudeOf(GetParam(), pose.orientation);
    ASSERT_EQ(attitude.freedoms(), GetParam() ? 2 : 3);
    for (int k = 0; k < attitude.freedoms(); ++k) {
      FreeAttitude::Turn turn = FreeAttitude::Turn::Zero(attitude.freedoms());
      turn(k) = 1e-5;
      const Eigen::Quaterniond more = attitude.turned(pose, turn).orientation;
      const Eigen::Quaterniond less = attitude.turned(pose, -turn).orientation;
      const Eigen::AngleAxisd difference(more * less.conjugate());
      const Eigen::Vector3d rate = difference.angle() / 2e-5 * difference.axis();
      EXPECT_LT((rate - attitude.axes(pose).col(k)).norm(), 1e-6) << i << " " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(HoldYaw, FreeAttitudes, testing::Bool());

TEST(HeldHeading, StaysThroughTurnsAndOtherAttitudes) {
  Dice dice(96);
  for (int i = 0; i < 50; ++i) {
    const double yaw = dice.uniform(-3.1, 3.1);
    const double pitch = dice.uniform(-1.2, 1.2);
    const Eigen::Vector3d angles(dice.uniform(-3.1, 3.1), pitch, yaw);
    Pose pose;
    pose.orientation = fromRollPitchYaw(angles);
    EXPECT_LT((rollPitchYaw(pose.orientation) - angles).norm(), 1e-12);
    const FreeAttitude attitude = attitudeOf(true, pose.orientation);
    const FreeAttitude::Turn turn = Eigen::Vector2d(dice.uniform(-0.2, 0.2), dice.uniform(-0.2, 0.2));
    EXPECT_NEAR(rollPitchYaw(attitude.turned(pose, turn).orientation).z(), yaw, 1e-12);
    pose.orientation = dice.attitude();
    EXPECT_NEAR(rollPitchYaw(attitude.allowed(pose).orientation).z(), yaw, 1e-12);
  }
}

TEST(HeldHeading, PitchStaysBelowARightAngle) {
  Pose pose;
  pose.orientation = fromRollPitchYaw({0.2, 1.5, 0.3});
  const FreeAttitude attitude = attitudeOf(true, pose.orientation);
  const Pose steep = attitude.turned(pose, attitude.most(pose));
  EXPECT_NEAR(rollPitchYaw(steep.orientation).z(), 0.3, 1e-9);
  EXPECT_LT(rollPitchYaw(steep.orientation).y(), 1.5707);
}

TEST(FixedAttitude, DoesNotTurn) {
  InverseRequest request;
  request.hold_yaw = true;  // without free_orientation it says nothing
  EXPECT_EQ(FreeAttitude(shippedRobot(ROBOT_DIR, "scampi"), request).freedoms(), 0);
  request.free_orientation = true;
  EXPECT_EQ(FreeAttitude(shippedRobot(ROBOT_DIR, "paper_point_mass"), request).freedoms(), 0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

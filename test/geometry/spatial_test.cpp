// Wrenches, small motions and rotations against differences of the motions themselves.
#include "geometry/spatial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kStep = 1e-6;      // of central differences, whose error is of its square
constexpr double kAccuracy = 1e-8;  // their rounding, for numbers of the size of one

Pose randomPose(Dice* dice) {
  Pose pose;
  pose.position = dice->inBox({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
  pose.orientation = dice->attitude();
  return pose;
}

Pose moved(const Pose& pose, const Wrench& motion) { return displaced(pose, motion.head<3>(), motion.tail<3>()); }

TEST(Spatial, TheCrossMatrixMakesTheCrossProduct) {
  Dice dice(1);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d a = dice.direction();
    const Eigen::Vector3d b = dice.direction();
    EXPECT_LT((cross(a) * b - Eigen::Vector3d(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                                              a.x() * b.y() - a.y() * b.x()))
                  .norm(),
              1e-15);
  }
}

// The work of a force on the motion of its point is that of its wrench on the motion of the platform.
TEST(Spatial, AWrenchDoesTheWorkOfItsForce) {
  Dice dice(2);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d arm = dice.direction();
    const Eigen::Vector3d force = dice.direction();
    for (int k = 0; k < 6; ++k) {
      const Wrench motion = Wrench::Unit(k);
      EXPECT_NEAR(wrenchAt(arm, force).dot(motion), force.dot(motionOfPoint(arm) * motion), 1e-15);
    }
  }
}

TEST(Spatial, APointMovesByTheDerivativeOfThePose) {
  Dice dice(3);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = randomPose(&dice);
    const Eigen::Vector3d point = dice.direction();
    const Eigen::Matrix<double, 3, 6> motion = motionOfPoint(pose.orientation * point);
    for (int k = 0; k < 6; ++k) {
      const Wrench step = kStep * Wrench::Unit(k);
      const Eigen::Vector3d slope =
          (moved(pose, step).transform(point) - moved(pose, -step).transform(point)) / (2.0 * kStep);
      EXPECT_LT((motion.col(k) - slope).norm(), kAccuracy) << k;
    }
  }
}

// A force that pulls its point towards the world's origin like a spring of stiffness 3 N/m.
TEST(Spatial, TheWrenchOfASpringChangesAsItsDerivativeSays) {
  const auto wrench = [](const Pose& pose, const Eigen::Vector3d& point) {
    return wrenchAt(pose.orientation * point, -3.0 * pose.transform(point));
  };
  Dice dice(4);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = randomPose(&dice);
    const Eigen::Vector3d point = dice.direction();
    const Eigen::Vector3d arm = pose.orientation * point;
    const Eigen::Matrix<double, 6, 6> derivative =
        wrenchByMotion(arm, -3.0 * pose.transform(point), -3.0 * motionOfPoint(arm));
    for (int k = 0; k < 6; ++k) {
      const Wrench step = kStep * Wrench::Unit(k);
      const Wrench slope = (wrench(moved(pose, step), point) - wrench(moved(pose, -step), point)) / (2.0 * kStep);
      EXPECT_LT((derivative.col(k) - slope).norm(), kAccuracy) << k;
    }
  }
}

TEST(Spatial, ADisplacementTurnsByItsRotationVector) {
  Dice dice(5);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = randomPose(&dice);
    const Eigen::Vector3d axis = dice.direction();
    const double angle = dice.uniform(0.0, 3.0);
    const Pose there = displaced(pose, Eigen::Vector3d::UnitX(), angle * axis);
    EXPECT_LT((there.position - pose.position - Eigen::Vector3d::UnitX()).norm(), 1e-15);
    EXPECT_NEAR(there.orientation.angularDistance(pose.orientation), angle, 1e-14);
    EXPECT_LT((there.orientation * pose.orientation.inverse() * axis - axis).norm(), 1e-14) << "the axis is kept";
    EXPECT_NEAR(there.orientation.norm(), 1.0, 1e-15);
  }
  const Pose pose = randomPose(&dice);
  EXPECT_EQ(displaced(pose, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()).orientation.coeffs(),
            pose.orientation.coeffs());
}

// q v with a quaternion that need not be of unit length, written out.
Eigen::Vector3d rotatedBy(const Eigen::Vector4d& q, const Eigen::Vector3d& v) {
  const Eigen::Vector3d u = q.head<3>();
  return v + 2.0 * q.w() * u.cross(v) + 2.0 * u.cross(u.cross(v));
}

TEST(Spatial, TheRotationJacobianIsTheDerivativeByTheQuaternion) {
  Dice dice(6);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Quaterniond q = dice.attitude();
    const Eigen::Vector3d v = dice.direction();
    const Eigen::Matrix<double, 3, 4> jacobian = rotationJacobian(q, v);
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector4d step = kStep * Eigen::Vector4d::Unit(k);
      const Eigen::Vector3d slope = (rotatedBy(q.coeffs() + step, v) - rotatedBy(q.coeffs() - step, v)) / (2.0 * kStep);
      EXPECT_LT((jacobian.col(k) - slope).norm(), kAccuracy) << k;
    }
  }
}

TEST(Spatial, ASmallChangeOfAQuaternionIsHalfItsRotation) {
  Dice dice(7);
  for (int i = 0; i < 20; ++i) {
    Pose pose = randomPose(&dice);
    const Eigen::Vector3d rotation = kStep * dice.direction();
    const Eigen::Vector4d change = (displaced(pose, Eigen::Vector3d::Zero(), rotation).orientation.coeffs() -
                                    displaced(pose, Eigen::Vector3d::Zero(), -rotation).orientation.coeffs()) /
                                   2.0;
    EXPECT_LT((rotationByQuaternion(pose.orientation) * change - rotation).norm(), kAccuracy * kStep);
  }
}

// About fixed axes, roll first: x goes to y by a yaw, y to z by a roll, z to x by a pitch of a right angle.
TEST(Spatial, RollPitchYawAreTurnsAboutFixedAxes) {
  const double right = 0.5 * M_PI;
  EXPECT_LT((fromRollPitchYaw({0.0, 0.0, right}) * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((fromRollPitchYaw({right, 0.0, 0.0}) * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
  EXPECT_LT((fromRollPitchYaw({0.0, right, 0.0}) * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(), 1e-15);
  // The roll takes y to z, where the yaw leaves it.
  EXPECT_LT((fromRollPitchYaw({right, 0.0, right}) * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(),
            1e-15);
  const Eigen::Vector3d angles(2.5, -1.1, -3.0);
  EXPECT_LT((rollPitchYaw(fromRollPitchYaw(angles)) - angles).norm(), 1e-14);
}

}  // namespace
}  // namespace cdpr_kinetostatics

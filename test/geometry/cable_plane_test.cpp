// A cable's plane and equation (35) against the world's coordinates and differences of the wrench.
#include "geometry/cable_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "cable/catenary.h"
#include "geometry/spatial.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct Case {
  Eigen::Vector3d anchor, attachment;
  Pose pose;
};

Case randomCase(Dice* dice) {
  Case c;
  c.anchor = dice->inBox({-5.0, -5.0, 3.0}, {5.0, 5.0, 5.0});
  c.attachment = dice->direction();
  c.pose.position = dice->inBox({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
  c.pose.orientation = dice->attitude();
  return c;
}

TEST(CablePlane, HoldsTheEndOfTheCable) {
  Dice dice(11);
  for (int i = 0; i < 50; ++i) {
    const Case c = randomCase(&dice);
    const CablePlane plane = cablePlane(c.anchor, c.attachment, c.pose);
    const Eigen::Vector3d b = c.pose.transform(c.attachment);
    EXPECT_LT((c.anchor + plane.x * plane.direction + plane.y * Eigen::Vector3d::UnitZ() - b).norm(), 1e-14);
    EXPECT_LT((anchorToAttachment(c.anchor, c.attachment, c.pose) - (b - c.anchor)).norm(), 1e-14);
    EXPECT_LT((c.pose.position + plane.arm - b).norm(), 1e-14);
    EXPECT_EQ(plane.direction.z(), 0.0);
    EXPECT_NEAR(plane.direction.norm(), 1.0, 1e-15);
    EXPECT_NEAR(plane.side().dot(plane.direction), 0.0, 1e-15);
    EXPECT_LT((plane.toPlane() * (b - c.anchor) - Eigen::Vector2d(plane.x, plane.y)).norm(), 1e-14);
  }
}

TEST(CablePlane, AVerticalCableTakesTheXAxis) {
  for (const double height : {-3.0, 3.0}) {
    const CablePlane plane =
        cablePlane({1.0, 2.0, 5.0}, {0.0, 0.0, height}, Pose{{1.0, 2.0, 5.0}, {1.0, 0.0, 0.0, 0.0}});
    EXPECT_EQ(plane.x, 0.0);
    EXPECT_EQ(plane.y, height);
    EXPECT_EQ(plane.direction, Eigen::Vector3d(Eigen::Vector3d::UnitX()));
  }
  EXPECT_GT(distanceBeside(0.0, 3.0), 0.0);
  EXPECT_EQ(distanceBeside(2.0, 3.0), 2.0);
}

TEST(CablePlane, ForcesActOnThePlatformAsEquation31Says) {
  Dice dice(12);
  for (int i = 0; i < 20; ++i) {
    const Case c = randomCase(&dice);
    const CablePlane plane = cablePlane(c.anchor, c.attachment, c.pose);
    const Eigen::Vector3d to_b = c.pose.transform(c.attachment) - c.anchor;
    const double x = std::hypot(to_b.x(), to_b.y());
    const Eigen::Vector3d force(-50.0 * to_b.x() / x, -50.0 * to_b.y() / x, 30.0 - 4.0);
    EXPECT_LT((forceOnPlatform(plane, 50.0, 30.0, 4.0) - force).norm(), 1e-12);
    const Eigen::Vector2d change(0.7, -0.3);
    const Eigen::Vector3d more = forceOnPlatform(plane, 50.7, 29.7, 4.0) - force;
    EXPECT_LT((plane.forceByForces() * change - more).norm(), 1e-12);
    EXPECT_LT((wrenchByForces(plane) * change - wrenchAt(plane.arm, more)).norm(), 1e-12);
  }
}

// A cable with the catenary between its ends at every pose: its wrench, and its part of the stiffness by (35).
constexpr double kLength = 8.0;

CableProperties rope() {
  CableProperties properties;
  properties.axial_stiffness = 2e4;
  properties.weight = 3.0;
  return properties;
}

Wrench catenaryWrench(const Case& c, const Pose& pose) {
  const CablePlane plane = cablePlane(c.anchor, c.attachment, pose);
  const auto forces = catenaryForces(rope(), kLength, plane.x, plane.y);
  return wrenchAt(plane.arm, forceOnPlatform(plane, forces->horizontal, forces->vertical, rope().weight * kLength));
}

Matrix6 catenaryStiffness(const Case& c) {
  const CablePlane plane = cablePlane(c.anchor, c.attachment, c.pose);
  const auto forces = catenaryForces(rope(), kLength, plane.x, plane.y);
  const EndPoint end = catenaryEnd(rope(), forces->horizontal, forces->vertical, kLength);
  const Eigen::Matrix2d jacobian = end.jacobian.leftCols<2>();
  Eigen::Matrix2d stiffness;
  stiffness << jacobian(1, 1), -jacobian(0, 1), -jacobian(1, 0), jacobian(0, 0);
  stiffness /= jacobian.determinant();
  Matrix6 total = Matrix6::Zero();
  addCableStiffness(plane, stiffness,
                    forceOnPlatform(plane, forces->horizontal, forces->vertical, rope().weight * kLength),
                    forceDensity(plane, forces->horizontal, stiffness), &total);
  return total;
}

// Central differences of sixth order.
Matrix6 differenced(const Case& c, double step) {
  constexpr double kWeights[] = {45.0, -9.0, 1.0};
  Matrix6 stiffness = Matrix6::Zero();
  for (int k = 0; k < 6; ++k) {
    for (int n = 1; n <= 3; ++n) {
      for (const double sign : {1.0, -1.0}) {
        const Wrench move = sign * n * step * Wrench::Unit(k);
        stiffness.col(k) += sign * kWeights[n - 1] / (60.0 * step) *
                            catenaryWrench(c, displaced(c.pose, move.head<3>(), move.tail<3>()));
      }
    }
  }
  return stiffness;
}

TEST(CablePlane, Equation35IsTheDerivativeOfTheWrench) {
  Dice dice(13);
  int taut = 0;
  for (int i = 0; i < 50; ++i) {
    const Case c = randomCase(&dice);
    const CablePlane plane = cablePlane(c.anchor, c.attachment, c.pose);
    const bool slack = std::hypot(plane.x, plane.y) < 0.98 * kLength;
    if (!slack && std::hypot(plane.x, plane.y) < 1.001 * kLength) continue;  // bends sharply from slack to taut
    taut += slack ? 0 : 1;
    const Matrix6 own = catenaryStiffness(c);
    EXPECT_LT((own - differenced(c, 1e-3)).norm(), 1e-6 * own.norm()) << i;
  }
  EXPECT_GT(taut, 0);
}

TEST(CablePlane, Equation35HoldsWithTheEndBelowTheAnchor) {
  Case c;
  c.anchor = {0.3, -0.2, 9.0};
  c.attachment = {0.1, 0.4, 0.2};
  c.pose.orientation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
  c.pose.position = c.anchor - c.pose.orientation * c.attachment - Eigen::Vector3d(0.0, 0.0, 1.002 * kLength);
  ASSERT_LT(cablePlane(c.anchor, c.attachment, c.pose).x, 1e-12);
  const Matrix6 own = catenaryStiffness(c);
  EXPECT_LT((own - differenced(c, 1e-4)).norm(), 1e-5 * own.norm());
}

}  // namespace
}  // namespace cdpr_kinetostatics

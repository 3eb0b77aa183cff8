// The law of a cable that turns with its chord: exact where it claims to be, and its derivative against differences.
#include "robot/chord_law.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace cdpr_kinetostatics {
namespace {

constexpr double kLength = 5.0;

CablePlane planeAt(const Eigen::Vector2d& end) {
  CablePlane plane;
  plane.arm = Eigen::Vector3d::Zero();
  plane.direction = Eigen::Vector3d::UnitX();
  plane.x = end.x();
  plane.y = end.y();
  return plane;
}

struct Started {
  SaggingCable cable;
  CablePlane plane;
  Eigen::Matrix2d stiffness;
  Eigen::Vector2d by_length;

  ChordLaw law(double new_length) const { return {cable, plane, stiffness, by_length, new_length}; }
};

CableProperties wire(double weight) {
  CableProperties properties;
  properties.axial_stiffness = 2e5;
  properties.weight = weight;
  return properties;
}

Eigen::Vector2d forcesAt(double weight, double length, const Eigen::Vector2d& end) {
  SaggingCable cable(wire(weight), Model::kCatenary, 1e-10);
  EXPECT_TRUE(cable.startBetween(length, end.x(), end.y(), {}).ok());
  return {cable.horizontalForce(), cable.verticalForceA()};
}

Started startedAt(double weight, const Eigen::Vector2d& end) {
  Started s;
  s.cable = SaggingCable(wire(weight), Model::kCatenary, 1e-10);
  EXPECT_TRUE(s.cable.startBetween(kLength, end.x(), end.y(), {}).ok());
  EXPECT_TRUE(s.cable.linearise(true));
  s.plane = planeAt(end);
  s.stiffness = s.cable.end().jacobian.leftCols<2>().inverse();
  s.by_length = -s.stiffness * s.cable.end().jacobian.col(2);
  return s;
}

const Eigen::Vector2d kEnd = 1.002 * kLength * Eigen::Vector2d(std::cos(-0.6), std::sin(-0.6));

TEST(ChordLaw, BeginsAtTheCable) {
  for (const double weight : {0.0, 3.0}) {
    const Started s = startedAt(weight, kEnd);
    const ChordLaw::Value value = s.law(kLength).at(s.plane);
    EXPECT_NEAR(value.forces.x(), s.cable.horizontalForce(), 1e-9);
    EXPECT_NEAR(value.forces.y(), s.cable.verticalForceA(), 1e-9);
    EXPECT_LT((value.stiffness - s.stiffness).norm(), 1e-9 * s.stiffness.norm());
  }
}

// Without weight a cable is a spring along its chord, and the law is no approximation however far it turns.
TEST(ChordLaw, IsExactForASpring) {
  const Started s = startedAt(0.0, kEnd);
  for (const double turn : {-1.4, -0.5, 0.3, 1.2}) {
    for (const double chord : {1.001, 1.0035}) {
      const Eigen::Vector2d end = chord * kLength * Eigen::Vector2d(std::cos(-0.6 + turn), std::sin(-0.6 + turn));
      const double tension = 2e5 * (chord - 1.0);
      const Eigen::Vector2d expected = tension * Eigen::Vector2d(std::cos(-0.6 + turn), -std::sin(-0.6 + turn));
      // The law is linear in the angle beyond the turn; for a spring nothing is left to be linear.
      EXPECT_LT((s.law(kLength).at(planeAt(end)).forces - expected).norm(), 1e-7 * tension) << turn << ", " << chord;
    }
  }
}

TEST(ChordLaw, ItsStiffnessIsTheDerivativeOfItsForces) {
  constexpr double kStep = 1e-6;
  const ChordLaw law = startedAt(3.0, kEnd).law(1.0003 * kLength);
  const Eigen::Vector2d end = kEnd + Eigen::Vector2d(0.12, 0.15);
  const Eigen::Matrix2d own = law.at(planeAt(end)).stiffness;
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(k);
    const Eigen::Vector2d slope =
        (law.at(planeAt(end + step)).forces - law.at(planeAt(end - step)).forces) / (2.0 * kStep);
    EXPECT_LT((own.col(k) - slope).norm(), 1e-7 * own.norm()) << k;
  }
}

// On a circle about A the law's error falls as the square of the angle and is small; the tangent's is a thousand times
// the force, as it takes the circle for stretch.
TEST(ChordLaw, FollowsACircleWhereTheTangentFails) {
  const Started s = startedAt(3.0, kEnd);
  double last = 0.0;
  for (const double turn : {0.1, 0.05}) {
    const Eigen::Vector2d end = 1.002 * kLength * Eigen::Vector2d(std::cos(-0.6 + turn), std::sin(-0.6 + turn));
    const Eigen::Vector2d exact = forcesAt(3.0, kLength, end);
    const double error = (s.law(kLength).at(planeAt(end)).forces - exact).norm();
    const Eigen::Vector2d tangent =
        Eigen::Vector2d(s.cable.horizontalForce(), s.cable.verticalForceA()) + s.stiffness * (end - kEnd);
    EXPECT_LT(error, 0.01 * (tangent - exact).norm()) << turn;
    EXPECT_TRUE(last == 0.0 || error < 0.35 * last) << error << " after " << last;
    last = error;
  }
}

TEST(ChordLaw, FollowsTheLength) {
  const Started s = startedAt(3.0, kEnd);
  double last = 0.0;
  for (const double change : {2e-4, 1e-4}) {
    const double length = kLength * (1.0 + change);
    const Eigen::Vector2d exact = forcesAt(3.0, length, kEnd);
    const double error = (s.law(length).at(s.plane).forces - exact).norm();
    EXPECT_LT(error, 0.02 * (exact - forcesAt(3.0, kLength, kEnd)).norm());
    EXPECT_TRUE(last == 0.0 || error < 0.35 * last) << error << " after " << last;
    last = error;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

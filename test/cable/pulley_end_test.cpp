// The closed forms on a guide pulley: derivatives by differences, and the geometric model of a rope without weight.
#include "cable/pulley_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cable/rope_on_pulley.h"

namespace cdpr_kinetostatics {
namespace {

using Case = std::tuple<FreeShape, RopeFrom>;

class EveryFreeShape : public ::testing::TestWithParam<Case> {
 protected:
  FreeShape shape() const { return std::get<0>(GetParam()); }
  CableProperties cable() const { return {3e4, 0.2, 3.0, {0.15, std::get<1>(GetParam())}, 5.0}; }
};

TEST_P(EveryFreeShape, HasTheDerivativesOfDifferences) {
  for (const ForcesAtA& at : {ForcesAtA{400.0, 300.0}, ForcesAtA{90.0, 20.0}, ForcesAtA{150.0, -200.0}}) {
    const double length = 7.0;
    const PulleyEnd end = pulleyEnd(cable(), shape(), at, length);
    const double steps[] = {1e-3 * at.tension(), 1e-3 * at.tension(), 1e-3 * length};
    for (int axis = 0; axis < 3; ++axis) {
      const auto moved = [&](double by) {
        const double d = by * steps[axis];
        return pulleyEnd(cable(), shape(), {at.horizontal + (axis == 0 ? d : 0.0), at.vertical + (axis == 1 ? d : 0.0)},
                         length + (axis == 2 ? d : 0.0));
      };
      const PulleyEnd a = moved(1.0), b = moved(-1.0), c = moved(2.0), d = moved(-2.0);
      const auto difference = [&](auto value) {
        return (8.0 * (value(a) - value(b)) - (value(c) - value(d))) / (12.0 * steps[axis]);
      };
      const auto size = [&](double scale) { return 1e-8 * scale / steps[axis] * 1e-3; };
      EXPECT_NEAR(end.free_length_by[axis], difference([](const PulleyEnd& e) { return e.free_length; }), size(length));
      EXPECT_NEAR(end.angle_by[axis], difference([](const PulleyEnd& e) { return e.angle; }), size(1.0));
      for (int row = 0; row < 2; ++row) {
        EXPECT_NEAR(end.end.jacobian(row, axis), difference([&](const PulleyEnd& e) { return e.end.position[row]; }),
                    size(length));
      }
    }
    EXPECT_NEAR(end.free_length + heldRope(cable(), at, end.angle).length, length, 1e-13 * length);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryFreeShape,
                         ::testing::Combine(::testing::Values(FreeShape::kStraight, FreeShape::kCatenary,
                                                              FreeShape::kCorrected),
                                            ::testing::Values(RopeFrom::kBelow, RopeFrom::kAbove)));

// Without weight, stretch and bending: an arc of phi r, then a straight line along its tangent.
TEST(PulleyEnd, OfAWeightlessRopeIsGeometry) {
  const double r = 0.2;
  const double length = 5.0;
  for (const double alpha : {-1.2, 0.1, 1.0}) {
    const ForcesAtA forces{100.0 * std::cos(alpha), -100.0 * std::sin(alpha)};
    for (const RopeFrom from : {RopeFrom::kBelow, RopeFrom::kAbove}) {
      const CableProperties rope{std::numeric_limits<double>::infinity(), 0.0, 0.0, {r, from}};
      // Over the top the rope turns from straight up to alpha, under the bottom from straight down.
      const double around = from == RopeFrom::kBelow ? 0.5 * M_PI - alpha : alpha + 0.5 * M_PI;
      const double on_circle = from == RopeFrom::kBelow ? M_PI - around : M_PI + around;
      const Eigen::Vector2d leaves(r + r * std::cos(on_circle), r * std::sin(on_circle));
      const Eigen::Vector2d end = leaves + (length - r * around) * Eigen::Vector2d(std::cos(alpha), std::sin(alpha));
      for (const FreeShape shape : {FreeShape::kStraight, FreeShape::kCatenary, FreeShape::kCorrected}) {
        EXPECT_LT((pulleyEnd(rope, shape, forces, length).end.position - end).norm(), 1e-14);
      }
    }
  }
}

TEST(PulleyEnd, ACableThatIsAllOnThePulleyHasNone) {
  const CableProperties rope{1e5, 0.0, 1.0, {0.2, RopeFrom::kBelow}};
  EXPECT_FALSE(pulleyEnd(rope, FreeShape::kCatenary, {10.0, 0.0}, 0.1).end.position.allFinite());
}

}  // namespace
}  // namespace cdpr_kinetostatics

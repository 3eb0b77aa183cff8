// The effect of bending on a catenary against its closed form, and where it is trusted.
#include "cable/bending_expansion.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

TEST(FirstOrderBending, AgreesWithTheIntegralInClosedFormWithoutStretch) {
  const CableProperties rope{std::numeric_limits<double>::infinity(), 0.44, 0.63};
  for (const double h : {0.3, 3.0, 30.0, 300.0}) {
    const double length = 9.0, v = 4.0;
    const double a = std::atan2(-v, h), b = std::atan2(rope.weight * length - v, h);
    const auto primitive = [](double alpha) {
      return Eigen::Vector2d(alpha / 4.0 + std::sin(2.0 * alpha) / 4.0 + std::sin(4.0 * alpha) / 16.0,
                             -std::pow(std::cos(alpha), 4) / 2.0);
    };
    const Eigen::Vector2d exact = rope.bending_stiffness * rope.weight / (h * h) * (primitive(b) - primitive(a));
    EXPECT_LT((firstOrderBending(rope, h, v, length).position - exact).norm(), 1e-10 * exact.norm()) << h;
  }
}

TEST(BendingExpansion, IsTrustedWhereThereIsNothingToExpand) {
  CableProperties rope = steelRope();
  EXPECT_TRUE(bendingExpansion(rope, 0.0, 20.0, 9.0).trusted) << "hangs straight down";
  EXPECT_EQ(bendingExpansion(rope, 0.0, 20.0, 9.0).end.norm(), 0.0);
  EXPECT_FALSE(bendingExpansion(rope, 0.0, 2.0, 9.0).trusted) << "a loop without width";
  EXPECT_FALSE(bendingExpansion(rope, -1.0, 2.0, 9.0).trusted) << "pushes";
  EXPECT_FALSE(bendingExpansion(paperBar(), 20.0, 30.0, 2.0).trusted) << "one bending layer";
  rope.bending_stiffness = 0.0;
  EXPECT_TRUE(bendingExpansion(rope, 3.0, 2.0, 9.0).trusted);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Problem 1 without horizontal force is the limit H -> 0+.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

using Generator = std::mt19937;

double uniform(Generator* dice, double low, double high) {
  return low + (high - low) * static_cast<double>((*dice)()) / 4294967296.0;
}

double logarithmic(Generator* dice, double low, double high) {
  return std::exp(uniform(dice, std::log(low), std::log(high)));
}

// Closed forms of a bar on two supports: 5 q L^4/(384 EI) and q L^2/8. MoorDyn's beam.
TEST(WithoutHorizontalForce, ABarThatLiesOnBothOfItsEnds) {
  const CableProperties beam{1.5e9, 1e7, 980.665};
  for (const double h : {0.0, 1e-14, -1e-14, 1e-9}) {
    const CableSolution s = findPosition(beam, 10.0, h, 4903.325, {});
    ASSERT_TRUE(s.status.ok()) << h << s.status.message;
    EXPECT_NEAR(s.x, 9.99996, 1e-5) << h;
    EXPECT_NEAR(s.y, 0.0, 1e-4) << h;
    EXPECT_NEAR(s.sag, 5.0 * 980.665 * 1e4 / (384.0 * 1e7), 1e-5) << h;
    EXPECT_NEAR(s.max_moment, 980.665 * 100.0 / 8.0, 0.5) << h;
  }
}

// It hangs stretched by its own weight: q L^2/(2 EA).
TEST(WithoutHorizontalForce, ABarThatHangsFreelyDoesNotStandUpright) {
  for (const CableProperties& cable : {paperBar(), steelRope()}) {
    for (const double length : {1.0, 5.0, 20.0}) {
      const double weight = cable.weight * length;
      for (const double h : {0.0, 1e-15, -1e-15}) {
        const CableSolution s = findPosition(cable, length, h, weight, {});
        ASSERT_TRUE(s.status.ok()) << length << s.status.message;
        EXPECT_NEAR(s.x, 0.0, 1e-8 * length);
        EXPECT_NEAR(s.y, -length - 0.5 * weight * length / cable.axial_stiffness, 1e-9 * length);
      }
      const CableSolution hangs_from_b = findPosition(cable, length, 0.0, 0.0, {});
      ASSERT_TRUE(hangs_from_b.status.ok()) << length << hangs_from_b.status.message;
      EXPECT_NEAR(hangs_from_b.y, length + 0.5 * weight * length / cable.axial_stiffness, 1e-9 * length);
    }
  }
}

// Any vertical force: the answer does not jump from that under a small horizontal force.
TEST(WithoutHorizontalForce, IsContinuousWithASmallOne) {
  Generator dice(17);
  for (int k = 0; k < 100; ++k) {
    const double length = logarithmic(&dice, 0.5, 50.0);
    const double q = logarithmic(&dice, 0.1, 100.0);
    const double stiffness = logarithmic(&dice, 1e-4, 1e3) * q * std::pow(length, 3);
    const CableProperties rod{logarithmic(&dice, 1e6, 1e10) * q * length, stiffness, q};
    const double v = q * length * uniform(&dice, -1.0, 2.0);
    const CableSolution limit = findPosition(rod, length, 0.0, v, {});
    ASSERT_TRUE(limit.status.ok()) << k << limit.status.message;
    const double h = 1e-6 * std::max(std::abs(v), q * length);
    const CableSolution pulled = findPosition(rod, length, h, v, {});
    ASSERT_TRUE(pulled.status.ok()) << k << pulled.status.message;
    EXPECT_LT(std::hypot(limit.x - pulled.x, limit.y - pulled.y), 0.01 * length)
        << k << ": EA " << rod.axial_stiffness << ", EI/(q L^3) " << stiffness / (q * length * length * length)
        << ", V/(q L) " << v / (q * length) << ": (" << limit.x << ", " << limit.y << ") and (" << pulled.x << ", "
        << pulled.y << ")";
  }
}

// Problem 2 straight below A and back: the end that problem 1 finds may lie behind A by rounding.
TEST(WithoutHorizontalForce, SlackRopesStraightBelowGoThereAndBack) {
  for (const double length : {2.5, 3.0, 4.0, 7.0}) {
    const CableSolution s = findForces(steelRope(), length, 0.0, -2.0, {});
    ASSERT_TRUE(s.status.ok()) << s.status.message;
    const CableSolution back = findPosition(steelRope(), length, s.horizontal_force, s.vertical_force_a, {});
    ASSERT_TRUE(back.status.ok()) << length << back.status.message;
    EXPECT_NEAR(back.x, 0.0, 1e-6);
    EXPECT_NEAR(back.y, -2.0, 1e-6);
  }
  // The same rope with forces of five digits.
  EXPECT_TRUE(findPosition(steelRope(), 3.0, -0.53504, 0.54735, {}).status.ok());
}

}  // namespace
}  // namespace cdpr_kinetostatics

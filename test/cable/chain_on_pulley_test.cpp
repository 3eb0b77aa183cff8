// The chain of shots on its pulley: end and free length follow (H, V, L) to first order, and a change is followed.
#include "cable/chain_on_pulley.h"

#include <gtest/gtest.h>

#include "cable/bending.h"
#include "cable/multiple_shooting.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-11;
constexpr double kLength = 9.0;
const ForcesAtA kForces{260.0, 150.0};

CableProperties rope() {
  CableProperties cable = steelRope();
  cable.pulley = {0.1, RopeFrom::kBelow};
  cable.dead_length = 7.0;
  return cable;
}

MultipleShooting solved(const ForcesAtA& forces, double length) {
  MultipleShooting shooting;
  EXPECT_TRUE(solveBendingPosition(rope(), length, forces, {kTolerance}, &shooting).ok());
  return shooting;
}

TEST(ChainOnPulley, EndAndFreeLengthHaveTheDerivativesOfDifferences) {
  const MultipleShooting at = solved(kForces, kLength);
  EXPECT_DOUBLE_EQ(at.length(), kLength);
  EXPECT_LT(at.freeLength(), kLength);
  const double steps[] = {0.1, 0.1, 1e-3};
  for (int axis = 0; axis < 3; ++axis) {
    const auto moved = [&](double by) {
      const double d = by * steps[axis];
      return solved({kForces.horizontal + (axis == 0 ? d : 0.0), kForces.vertical + (axis == 1 ? d : 0.0)},
                    kLength + (axis == 2 ? d : 0.0));
    };
    const MultipleShooting more = moved(1.0), less = moved(-1.0);
    const Eigen::Vector2d end = (more.end().position - less.end().position) / (2.0 * steps[axis]);
    EXPECT_LT((at.end().jacobian.col(axis) - end).norm(), 1e-5 * end.norm()) << axis;
    const double free = (more.freeLength() - less.freeLength()) / (2.0 * steps[axis]);
    EXPECT_NEAR(at.freeLengthDerivative()[axis], free, 1e-5 * at.freeLengthDerivative().cwiseAbs()[axis] + 1e-9)
        << axis;
  }
}

// Where a chain is moved along its equilibria the end is met to second order.
TEST(ChainOnPulley, FollowsAChangeToSecondOrder) {
  double last = 0.0;
  for (const double size : {1e-2, 1e-3}) {
    MultipleShooting shooting = solved(kForces, kLength);
    const Eigen::Vector3d change = size * Eigen::Vector3d(50.0, -70.0, 0.1);
    shooting.follow(change);
    EXPECT_DOUBLE_EQ(shooting.length(), kLength + change.z());
    const MultipleShooting there =
        solved({kForces.horizontal + change.x(), kForces.vertical + change.y()}, kLength + change.z());
    const double missed = std::abs(shooting.freeLength() - there.freeLength());
    if (last > 0.0) {
      EXPECT_LT(missed, 0.02 * last);
    }
    last = missed;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

// What the parts of a chain may be wrong by, against beams and ropes whose answers are known by hand.
#include "cable/shooting_accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cdpr_kinetostatics {
namespace {

TEST(ShootingAccuracy, PartsAreMoreAccurateThanTheWhole) {
  for (const double tolerance : {1e-6, 1e-9}) {
    const ShootingAccuracy accuracy(tolerance);
    EXPECT_EQ(accuracy.tolerance(), tolerance);
    EXPECT_LT(accuracy.ofStep(), tolerance);
    EXPECT_LT(accuracy.ofQuietInterval(), accuracy.ofStep());
    EXPECT_EQ(accuracy.fewestShots(), 1);
    // Errors of the angle that count ten times as much are asked to be ten times smaller.
    const ShootingAccuracy finer(tolerance, 0.1);
    EXPECT_NEAR(finer.ofStep(), 0.1 * accuracy.ofStep(), 1e-12 * tolerance);
    EXPECT_NEAR(finer.ofQuietInterval(), 0.1 * accuracy.ofQuietInterval(), 1e-12 * tolerance);
  }
  EXPECT_GT(ShootingAccuracy(1e-8, 0.01).fewestShots(), 1);
}

TEST(ShootingAccuracy, ASaggingRopeIsRuledByTheAngleThatItTurns) {
  const CableProperties rope{1e5, 1e-3, 1.0};  // hardly any bending stiffness: a beam of it would turn by 40 rad
  for (const double turned : {0.003, 0.2}) EXPECT_EQ(angleScale(rope, 1.0, 50.0, turned), turned);
  EXPECT_EQ(angleScale(rope, 1.0, 50.0, 2.0), 1.0);
}

// A bar of 1 m that turns by q L^3/(24 EI) = 1e-5 rad under its weight: an angle of it moves the end as much as a force
// F that stretches it by the same, F/EA.
TEST(ShootingAccuracy, AStiffBarIsRuledByItsStretch) {
  const CableProperties bar{1e7, 1e5, 24.0};
  EXPECT_NEAR(angleScale(bar, 1.0, 1e2, 0.5), 0.5, 1e-12);   // 1e2/1e7/1e-5 = 1: the turn is less
  EXPECT_NEAR(angleScale(bar, 1.0, 1.0, 0.5), 0.01, 1e-12);  // 1/1e7/1e-5
  EXPECT_GE(angleScale(bar, 1.0, 1e-12, 0.5), 1e-7);         // never so small that rounding rules
  EXPECT_GT(angleScale(bar, 1.0, 1e-12, 0.5), 0.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

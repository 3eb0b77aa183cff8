// The line: what it carries, by statics, and what it refuses.
#include "cable/straight_cable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cdpr_kinetostatics {
namespace {

const CableProperties kElastic{1000.0, 0.0, 2.0};
const CableProperties kRigid{std::numeric_limits<double>::infinity(), 0.0, 2.0};
constexpr double kX = 3.0, kY = -4.0, kChord = 5.0;

// Hooke's law along the chord, and half of the weight at A.
TEST(StraightCable, CarriesItsStretchAndHalfItsWeight) {
  StraightCable line(kElastic);
  ASSERT_TRUE(line.startBetween(4.0, kX, kY, {}).ok());
  EXPECT_NEAR(line.forces().horizontal, 250.0 * 0.6, 1e-12);
  EXPECT_NEAR(line.forces().vertical, 250.0 * 0.8 + 4.0, 1e-12);
  EXPECT_NEAR((line.end().position - Eigen::Vector2d(kX, kY)).norm(), 0.0, 1e-14);
  const CableSolution s = line.describe(kX, kY, 3);
  EXPECT_NEAR(s.strained_length, kChord, 1e-14);
  EXPECT_NEAR(s.profile[1].x, 0.5 * kX, 1e-15);
  EXPECT_NEAR(s.profile[1].tension, 250.0, 1e-12);
}

TEST(StraightCable, ThatIsSlackHasNoTensionAndNoDerivatives) {
  StraightCable line(kElastic);
  ASSERT_TRUE(line.startBetween(6.0, kX, kY, {}).ok());
  EXPECT_EQ(line.forces().horizontal, 0.0);
  EXPECT_EQ(line.forces().vertical, 6.0);
  EXPECT_FALSE(line.linearise(true));
}

// T_A^2 = H^2 + V^2 with the line's own force along the chord and half of the weight besides.
TEST(StraightCable, WithoutStretchTakesTheTensionAtA) {
  StraightCable line(kRigid);
  double least = 0.0;
  ASSERT_TRUE(line.startWithTension(kX, kY, 50.0, &least).ok());
  EXPECT_NEAR(line.forces().tension(), 50.0, 1e-12);
  EXPECT_EQ(line.length(), kChord);
  const double along = line.forces().horizontal / 0.6;
  EXPECT_NEAR(line.forces().vertical, 0.8 * along + 5.0, 1e-12);
  EXPECT_EQ(line.startWithTension(kX, kY, 4.0, &least).status.code, Code::kInfeasible);
  EXPECT_NEAR(least, 5.0, 1e-15) << "the half of the weight that hangs from A";
  EXPECT_EQ(line.startBetween(kChord, kX, kY, {}).status.code, Code::kInvalidInput);
  EXPECT_EQ(line.startBetween(6.0, kX, kY, {}).status.code, Code::kInfeasible);
}

TEST(StraightCable, RefusesToPushAndToPointNowhere) {
  StraightCable line(kElastic);
  EXPECT_EQ(line.startUnder(4.0, {-1.0, 4.0}, {}).status.code, Code::kInfeasible);
  EXPECT_EQ(line.startUnder(4.0, {0.0, 4.0}, {}).status.code, Code::kInvalidInput);
}

}  // namespace
}  // namespace cdpr_kinetostatics

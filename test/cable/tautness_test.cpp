// Which forces push, and which pull all along a cable.
#include "cable/tautness.h"

#include <gtest/gtest.h>

namespace cdpr_kinetostatics {
namespace {

constexpr double kLength = 10.0;
const CableProperties kCable{1e5, 0.0, 2.0};  // weighs 20 N

TEST(Tautness, AForceAgainstTheDirectionOfBPushesUnlessThatIsRounding) {
  EXPECT_TRUE(pushes({-1e-6, 30.0}));
  EXPECT_FALSE(pushes({-1e-12, 30.0}));
  EXPECT_FALSE(pushes({0.0, 0.0}));
  EXPECT_FALSE(pushes({1e-6, 30.0}));
  EXPECT_EQ(withoutRounding({-1e-12, 30.0}).horizontal, 0.0);
  EXPECT_EQ(withoutRounding({-1e-6, 30.0}).horizontal, -1e-6);
  EXPECT_EQ(withoutRounding({1e-12, 30.0}).horizontal, 1e-12);
}

// A vertical cable hangs on its upper end alone (V > q L), on B alone (V < 0), or on both, in a loop whose lowest point
// carries nothing.
TEST(Tautness, AVerticalCablePullsAllAlongIfItHangsOnOneEnd) {
  EXPECT_TRUE(pullsAllAlong(kCable, kLength, {0.0, 21.0}));
  EXPECT_TRUE(pullsAllAlong(kCable, kLength, {0.0, -1.0}));
  EXPECT_FALSE(pullsAllAlong(kCable, kLength, {0.0, 0.0}));
  EXPECT_FALSE(pullsAllAlong(kCable, kLength, {0.0, 10.0}));
  EXPECT_FALSE(pullsAllAlong(kCable, kLength, {0.0, 20.0}));
  EXPECT_TRUE(pullsAllAlong(kCable, kLength, {-1e-12, 21.0}));
  EXPECT_FALSE(pullsAllAlong(kCable, kLength, {-1e-3, 21.0}));
  EXPECT_TRUE(pullsAllAlong(kCable, kLength, {1e-9, 10.0}));
}

}  // namespace
}  // namespace cdpr_kinetostatics

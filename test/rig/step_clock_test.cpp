#include "rig/step_clock.h"

#include <gtest/gtest.h>

namespace cdpr_kinetostatics {
namespace {

TEST(StepClock, StepsAreAPeriodApart) {
  StepClock clock(4.0);
  EXPECT_TRUE(clock.isDue(10.0));
  EXPECT_FALSE(clock.isDue(10.0));
  EXPECT_FALSE(clock.isDue(10.24));
  EXPECT_TRUE(clock.isDue(10.3));
  EXPECT_EQ(clock.timeOfNext(), 10.5) << "a late step does not shift those that follow";
  EXPECT_TRUE(clock.isDue(10.5));
}

TEST(StepClock, StepsThatCannotKeepUpAreNotMadeUpFor) {
  StepClock clock(4.0);
  EXPECT_TRUE(clock.isDue(10.0));
  EXPECT_TRUE(clock.isDue(20.0));
  EXPECT_FALSE(clock.isDue(20.1));
  EXPECT_EQ(clock.timeOfNext(), 20.25);
}

TEST(StepClock, ClockThatGoesBackStartsAnew) {
  StepClock clock(4.0);
  EXPECT_TRUE(clock.isDue(1000.0));
  EXPECT_TRUE(clock.isDue(0.1));
  EXPECT_FALSE(clock.isDue(0.2));
  EXPECT_TRUE(clock.isDue(0.35));
}

// ros::Time ends at 2^32 s.
TEST(StepClock, GoesOnToTheEndOfTime) {
  StepClock clock(100.0);
  const double end = 4294967295.0;
  EXPECT_TRUE(clock.isDue(1.0));
  EXPECT_TRUE(clock.isDue(end - 1.0));
  int steps = 0;
  for (int k = 1; k <= 1000; ++k) steps += clock.isDue(end - 1.0 + 1e-3 * k) ? 1 : 0;
  EXPECT_NEAR(steps, 100, 1);
  EXPECT_FALSE(clock.isDue(end));
  EXPECT_TRUE(clock.isDue(1.0));
}

}  // namespace
}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/cable/solve_limits.h"

#include <gtest/gtest.h>

#include <limits>

namespace cdpr_kinetostatics {
namespace {

using Seconds = std::chrono::duration<double>;

TEST(SolveLimits, ADeadlineIsThatLongFromNow) {
  const auto before = SolveLimits::Clock::now();
  const auto deadline = deadlineAfter(Seconds(2.0));
  const auto after = SolveLimits::Clock::now();
  EXPECT_GE(Seconds(deadline - before).count(), 2.0 - 1e-6);  // the clock's resolution
  EXPECT_LE(Seconds(deadline - after).count(), 2.0);
  EXPECT_LT(deadlineAfter(Seconds(-1.0)), after);
}

TEST(SolveLimits, TimeoutsThatTheClockCannotHoldNeverEnd) {
  for (const double timeout :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    EXPECT_EQ(deadlineAfter(Seconds(timeout)), SolveLimits::Clock::time_point::max()) << timeout;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Counts from doubles that are no counts.
#include "cable/bounded_count.h"

#include <gtest/gtest.h>

#include <limits>

namespace cdpr_kinetostatics {
namespace {

TEST(BoundedCount, RoundsUpBetweenItsBounds) {
  EXPECT_EQ(boundedCount(3.0, 1, 10), 3);
  EXPECT_EQ(boundedCount(3.1, 1, 10), 4);
  EXPECT_EQ(boundedCount(0.2, 1, 10), 1);
  EXPECT_EQ(boundedCount(9.5, 1, 10), 10);
}

TEST(BoundedCount, TakesWhatIsNoNumberForTooMany) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(boundedCount(std::numeric_limits<double>::quiet_NaN(), 1, 10), 10);
  EXPECT_EQ(boundedCount(kInfinity, 1, 10), 10);
  EXPECT_EQ(boundedCount(-kInfinity, 1, 10), 1);
  EXPECT_EQ(boundedCount(1e300, 1, 10), 10);
  EXPECT_EQ(boundedCount(-1e300, 1, 10), 1);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The cable that bends: followed where it can be, started anew where not, and copied without the heap.
#include "cable/bending_cable.h"

#include <gtest/gtest.h>

#include "counted_allocations.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr SolveLimits kLimits{1e-9};

TEST(BendingCable, IsFollowedToAnEndNearbyInFewerIterationsThanAnew) {
  BendingCable followed(steelRope(), 1e-9);
  ASSERT_TRUE(followed.startBetween(8.5, 7.0, -4.0, kLimits).ok());
  const SolveOutcome warm = followed.followBetween(8.501, 7.001, -4.0, kLimits);
  BendingCable anew(steelRope(), 1e-9);
  const SolveOutcome cold = anew.startBetween(8.501, 7.001, -4.0, kLimits);
  ASSERT_TRUE(warm.ok() && cold.ok());
  EXPECT_LE(warm.iterations, cold.iterations);
  EXPECT_NEAR(followed.forces().horizontal, anew.forces().horizontal, 1e-7 * anew.forces().tension());
  EXPECT_NEAR(followed.forces().vertical, anew.forces().vertical, 1e-7 * anew.forces().tension());
}

// From a taut bar to one that is far longer than its chord: no way for Newton's method alone.
TEST(BendingCable, IsStartedAnewWhereItCannotBeFollowed) {
  BendingCable followed(paperBar(), 1e-9);
  ASSERT_TRUE(followed.startBetween(5.592, 5.0, -2.5, kLimits).ok());
  ASSERT_TRUE(followed.followBetween(12.0, 5.0, -2.5, kLimits).ok());
  EXPECT_TRUE(followed.onBranch());
  BendingCable anew(paperBar(), 1e-9);
  ASSERT_TRUE(anew.startBetween(12.0, 5.0, -2.5, kLimits).ok());
  EXPECT_NEAR(followed.forces().horizontal, anew.forces().horizontal, 1e-7 * anew.forces().tension());
}

TEST(BendingCable, IsCopiedToAnotherWithoutTheHeap) {
  BendingCable from(steelRope(), 1e-9), to(steelRope(), 1e-9);
  ASSERT_TRUE(from.startBetween(8.5, 7.0, -4.0, kLimits).ok());
  to = from;
  ASSERT_TRUE(from.followBetween(8.501, 7.001, -4.0, kLimits).ok());
  const long before = heapCount().allocations;
  to = from;
  EXPECT_EQ(heapCount().allocations, before);
  EXPECT_EQ(to.length(), from.length());
}

}  // namespace
}  // namespace cdpr_kinetostatics

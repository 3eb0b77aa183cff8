// Problem 1 of the bending cable: it finds the end again that problem 2 took its forces from, whatever the shape.
#include <gtest/gtest.h>

#include <cmath>

#include "cable/bending.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-10;

SolveLimits limits() {
  SolveLimits result;
  result.tolerance = kTolerance;
  return result;
}

struct End {
  const char* shape;
  CableProperties cable;
  double length, x, y;
};

const End kEnds[] = {
    {"taut rope", steelRope(), 10.0, 9.0, -4.3},
    {"slack rope", steelRope(), 10.0, 6.0, 1.0},
    {"narrow loop of a rope", steelRope(), 6.0, 0.3, -2.0},
    {"loop of a bar", paperBar(), 5.0, 2.0, 0.5},
    {"bowed bar", paperBar(), 5.0, 4.6, 1.0},
    {"bar in its chord", paperBar(), 5.0, 4.0, -3.0},
};

TEST(BendingPosition, FindsTheEndThatTheForcesCameFrom) {
  for (const End& end : kEnds) {
    SCOPED_TRACE(end.shape);
    MultipleShooting between;
    const SolveOutcome forward = solveBendingForces(end.cable, end.length, end.x, end.y, limits(), &between);
    ASSERT_TRUE(forward.ok()) << forward.status.message;
    const ForcesAtA forces{between.horizontalForce(), between.verticalForceA()};
    MultipleShooting under;
    const SolveOutcome back = solveBendingPosition(end.cable, end.length, forces, limits(), &under);
    ASSERT_TRUE(back.ok()) << back.status.message;
    EXPECT_NEAR(under.end().position.x(), end.x, 1e-6 * end.length);
    EXPECT_NEAR(under.end().position.y(), end.y, 1e-6 * end.length);
    EXPECT_TRUE(onSaggingBranch(under));
  }
}

TEST(BendingPosition, FollowingMovesTheEndByItsCompliance) {
  MultipleShooting shooting;
  const CableProperties rope = steelRope();
  ASSERT_TRUE(solveBendingPosition(rope, 10.0, {300.0, 100.0}, limits(), &shooting).ok());
  const Eigen::Vector2d before = shooting.end().position;
  const Eigen::Vector2d step(0.3, -0.2);
  const Eigen::Vector2d expected = before + shooting.end().jacobian.leftCols<2>() * step;
  ASSERT_TRUE(followBendingPosition(10.0, {300.0 + step.x(), 100.0 + step.y()}, limits(), &shooting).ok());
  EXPECT_LT((shooting.end().position - expected).norm(), 1e-2 * (expected - before).norm());
}

TEST(BendingPosition, StopsAtItsDeadline) {
  SolveLimits over = limits();
  over.deadline = SolveLimits::Clock::now() - std::chrono::seconds(1);
  MultipleShooting shooting;
  EXPECT_EQ(solveBendingPosition(steelRope(), 6.0, {-0.5, 1.0}, over, &shooting).status.code, Code::kTimedOut);
}

}  // namespace
}  // namespace cdpr_kinetostatics

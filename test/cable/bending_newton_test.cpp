// Newton's method on one bending cable: both of its goals lead to the same equilibrium, and it says how it ended.
#include "cable/bending_newton.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cable/catenary.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

SolveLimits limits(double tolerance) {
  SolveLimits result;
  result.tolerance = tolerance;
  return result;
}

TEST(BendingNewton, ForcesAndEndPointAreGoalsOfOneEquilibrium) {
  const double length = 10.0;
  const Eigen::Vector2d forces(300.0, 120.0);
  MultipleShooting under;
  under.start(steelRope(), length, forces.x(), forces.y(), 1e-10);
  const SolveOutcome first = newton({Goal::kForces, length, forces}, limits(1e-10), kMaxNewtonIterations, &under);
  ASSERT_TRUE(first.ok()) << first.status.message;
  EXPECT_GT(first.iterations, 0);
  const Eigen::Vector2d end = under.end().position;

  MultipleShooting between;  // from other forces
  between.start(steelRope(), length, 1.01 * forces.x(), 0.99 * forces.y(), 1e-10);
  const SolveOutcome second = newton({Goal::kEndPoint, length, end}, limits(1e-10), kMaxNewtonIterations, &between);
  ASSERT_TRUE(second.ok()) << second.status.message;
  EXPECT_LT(second.closure_residual, 1e-10 * length);
  EXPECT_LT(second.moment_residual, 1e-9);
  EXPECT_NEAR(between.horizontalForce(), forces.x(), 1e-6 * forces.norm());
  EXPECT_NEAR(between.verticalForceA(), forces.y(), 1e-6 * forces.norm());
}

TEST(BendingNewton, TakesTheLengthAlong) {
  MultipleShooting shooting;
  shooting.start(steelRope(), 10.0, 300.0, 120.0, 1e-10);
  ASSERT_TRUE(newton({Goal::kForces, 10.2, {300.0, 120.0}}, limits(1e-10), kMaxNewtonIterations, &shooting).ok());
  EXPECT_NEAR(shooting.length(), 10.2, 1e-12);
  MultipleShooting fresh;
  fresh.start(steelRope(), 10.2, 300.0, 120.0, 1e-10);
  ASSERT_TRUE(newton({Goal::kForces, 10.2, {300.0, 120.0}}, limits(1e-10), kMaxNewtonIterations, &fresh).ok());
  EXPECT_LT((shooting.end().position - fresh.end().position).norm(), 1e-8);
}

TEST(BendingNewton, SaysThatIterationsOrTimeRanOut) {
  MultipleShooting shooting;
  shooting.start(steelRope(), 10.0, 300.0, 120.0, 1e-10);
  const SolveOutcome few = newton({Goal::kEndPoint, 10.0, {9.0, -3.5}}, limits(1e-10), 1, &shooting);
  EXPECT_EQ(few.status.code, Code::kNotConverged);
  EXPECT_EQ(few.iterations, 1);
  EXPECT_FALSE(few.status.message.empty());
  SolveLimits over = limits(1e-10);
  over.deadline = SolveLimits::Clock::now() - std::chrono::seconds(1);
  EXPECT_EQ(newton({Goal::kEndPoint, 10.0, {9.0, -3.5}}, over, kMaxNewtonIterations, &shooting).status.code,
            Code::kTimedOut);
}

// (lambda/R)^2 = EI/T / R^2 with R = T^2/(q H) at the lowest point, where T = H: EI q^2/H^3.
TEST(BendingNewton, TheSharpestBendIsThatOfTheLowestPoint) {
  const CableProperties rope = steelRope();
  const double h = 4.0;
  const double expected = rope.bending_stiffness * rope.weight * rope.weight / std::pow(h, 3);
  EXPECT_NEAR(sharpestBend(rope, 10.0, {h, 0.5 * rope.weight * 10.0}), expected, 1e-9 * expected);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The nearest point of a polytope against enumeration of all active sets.
#include "robot/nearest_in_polytope.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <optional>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-12;

struct Problem {
  Eigen::VectorXd x0;
  Eigen::MatrixXd normals;
  Eigen::VectorXd bounds;

  bool holds(const Eigen::VectorXd& x, double tolerance) const {
    return ((normals.transpose() * x - bounds).array() >= -tolerance).all();
  }
};

// The nearest of the projections onto every set of constraints taken as equations that satisfies all others.
std::optional<Eigen::VectorXd> enumerated(const Problem& p) {
  std::optional<Eigen::VectorXd> best;
  const auto m = static_cast<int>(p.bounds.size());
  for (int set = 0; set < (1 << m); ++set) {
    std::vector<int> active;
    for (int i = 0; i < m; ++i) {
      if ((set >> i) & 1) active.push_back(i);
    }
    if (static_cast<Eigen::Index>(active.size()) > p.x0.size()) continue;
    Eigen::VectorXd x = p.x0;
    if (!active.empty()) {
      const Eigen::MatrixXd n = p.normals(Eigen::all, active);
      const Eigen::VectorXd missing = p.bounds(active) - n.transpose() * p.x0;
      x += n.transpose().completeOrthogonalDecomposition().solve(missing);
      if (!x.allFinite() || (n.transpose() * x - p.bounds(active)).norm() > 1e-8) continue;
    }
    if (!p.holds(x, 1e-11)) continue;
    if (!best || (x - p.x0).norm() < (*best - p.x0).norm()) best = x;
  }
  return best;
}

Eigen::VectorXd randomVector(Eigen::Index n, double size, Dice* dice) {
  Eigen::VectorXd v(n);
  for (double& value : v) value = dice->uniform(-size, size);
  return v;
}

Problem randomProblem(Eigen::Index n, Eigen::Index m, double shift, Dice* dice) {
  Problem p;
  p.x0 = randomVector(n, 2.0, dice);
  p.normals = Eigen::MatrixXd(n, m);
  for (Eigen::Index i = 0; i < m; ++i) p.normals.col(i) = randomVector(n, 1.0, dice);
  p.bounds = randomVector(m, 1.0, dice) + Eigen::VectorXd::Constant(m, shift);
  return p;
}

// Normals times multipliers, none negative, of the constraints said to be active, is the way from x0 to x.
void expectOptimal(const Problem& p, const NearestPoint& nearest) {
  EXPECT_TRUE(p.holds(nearest.x, 10.0 * kTolerance));
  Eigen::VectorXd step = nearest.x - p.x0;
  if (nearest.active.empty()) {
    EXPECT_EQ(step.norm(), 0.0);
    return;
  }
  const Eigen::MatrixXd n = p.normals(Eigen::all, nearest.active);
  const Eigen::VectorXd multipliers = n.colPivHouseholderQr().solve(step);
  EXPECT_LT((n * multipliers - step).norm(), 1e-9 * (1.0 + step.norm()));
  EXPECT_GE(multipliers.minCoeff(), -1e-9 * (1.0 + step.norm()));
  EXPECT_LT((n.transpose() * nearest.x - p.bounds(nearest.active)).norm(), 1e-9);
}

TEST(BoundedQp, IsTheBestOfAllActiveSets) {
  Dice dice(41);
  int feasible = 0, infeasible = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto n = static_cast<Eigen::Index>(1 + i % 4);
    const auto m = static_cast<Eigen::Index>(1 + (i / 4) % 9);
    const Problem p = randomProblem(n, m, dice.uniform(-1.0, 1.0), &dice);
    const NearestPoint nearest = nearestInPolytope(p.x0, p.normals, p.bounds, kTolerance);
    const std::optional<Eigen::VectorXd> best = enumerated(p);
    ASSERT_EQ(nearest.feasible, best.has_value()) << "problem " << i;
    ++(nearest.feasible ? feasible : infeasible);
    if (!nearest.feasible) continue;
    EXPECT_LT((nearest.x - *best).norm(), 1e-8) << "problem " << i;
    expectOptimal(p, nearest);
  }
  EXPECT_GT(feasible, 400);
  EXPECT_GT(infeasible, 200);
}

TEST(BoundedQp, ManyConstraintsInTwoAndThreeDimensions) {
  Dice dice(42);
  for (int i = 0; i < 300; ++i) {
    const Problem p = randomProblem(2 + i % 2, 40, -2.0, &dice);
    const NearestPoint nearest = nearestInPolytope(p.x0, p.normals, p.bounds, kTolerance);
    if (!nearest.feasible) continue;
    expectOptimal(p, nearest);
  }
}

TEST(BoundedQp, WithoutConstraintsOrInsideThemThePointStays) {
  const Eigen::Vector2d x0(1.0, 2.0);
  EXPECT_EQ(nearestInPolytope(x0, Eigen::MatrixXd(2, 0), Eigen::VectorXd(0), kTolerance).x, x0);
  const NearestPoint inside = nearestInPolytope(x0, Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero(), kTolerance);
  EXPECT_TRUE(inside.feasible);
  EXPECT_TRUE(inside.active.empty());
  EXPECT_EQ(inside.x, x0);
}

TEST(BoundedQp, ConstraintsGivenTwiceDoNoHarm) {
  Dice dice(43);
  for (int i = 0; i < 200; ++i) {
    Problem p = randomProblem(3, 6, -0.5, &dice);
    Problem doubled = p;
    doubled.normals.resize(3, 12);
    doubled.normals << p.normals, p.normals;
    doubled.bounds.resize(12);
    doubled.bounds << p.bounds, p.bounds;
    const NearestPoint once = nearestInPolytope(p.x0, p.normals, p.bounds, kTolerance);
    const NearestPoint twice = nearestInPolytope(doubled.x0, doubled.normals, doubled.bounds, kTolerance);
    ASSERT_EQ(once.feasible, twice.feasible) << "problem " << i;
    if (!once.feasible) continue;
    EXPECT_LT((once.x - twice.x).norm(), 1e-9) << "problem " << i;
  }
}

TEST(BoundedQp, ContradictionNamesConstraintsThatCannotAllHold) {
  Dice dice(44);
  int seen = 0;
  for (int i = 0; i < 500; ++i) {
    const Problem p = randomProblem(2, 8, 0.6, &dice);
    const NearestPoint nearest = nearestInPolytope(p.x0, p.normals, p.bounds, kTolerance);
    if (nearest.feasible) continue;
    ++seen;
    ASSERT_FALSE(nearest.active.empty());
    const Problem alone{p.x0, p.normals(Eigen::all, nearest.active), p.bounds(nearest.active)};
    EXPECT_FALSE(enumerated(alone).has_value()) << "problem " << i;
  }
  EXPECT_GT(seen, 50);
}

TEST(BoundedQp, ZeroNormalContradictsIfItsBoundIsPositive) {
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(2, 1);
  EXPECT_FALSE(nearestInPolytope(Eigen::Vector2d(1.0, 1.0), normals, Eigen::VectorXd::Constant(1, 1.0), 1e-9).feasible);
  EXPECT_TRUE(nearestInPolytope(Eigen::Vector2d(1.0, 1.0), normals, Eigen::VectorXd::Constant(1, -1.0), 1e-9).feasible);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Tensions that balance a wrench within limits, nearest to preferred ones.
#include "cdpr_kinetostatics/robot/tension_distribution.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <vector>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Eigen::MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, Dice* dice) {
  Eigen::MatrixXd m(rows, columns);
  for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = dice->uniform(-1.0, 1.0);
  return m;
}

// Balanced by tensions within 20 to 80 N; limits 10 to 100 N.
TensionProblem randomProblem(Eigen::Index rows, Eigen::Index n, Dice* dice) {
  TensionProblem p;
  p.matrix = randomMatrix(rows, n, dice);
  Eigen::VectorXd inside(n);
  for (double& t : inside) t = dice->uniform(20.0, 80.0);
  p.wrench = p.matrix * inside;
  p.preferred = 60.0 * (randomMatrix(n, 1, dice) + Eigen::VectorXd::Ones(n));
  p.weight = randomMatrix(n, 1, dice).cwiseAbs() + Eigen::VectorXd::Constant(n, 0.1);
  p.lower = Eigen::VectorXd::Constant(n, 10.0);
  p.upper = Eigen::VectorXd::Constant(n, 100.0);
  return p;
}

// Gradient = matrix^T multipliers + limits' multipliers of the right sign.
void expectOptimal(const TensionProblem& p, const TensionDistribution& d) {
  const Eigen::VectorXd gradient = p.weight.cwiseAbs2().cwiseProduct(d.tensions - p.preferred);
  const Eigen::Index n = p.preferred.size();
  Eigen::MatrixXd directions(n, p.matrix.rows() + static_cast<Eigen::Index>(d.at_lower.size() + d.at_upper.size()));
  directions.leftCols(p.matrix.rows()) = p.matrix.transpose();
  Eigen::Index column = p.matrix.rows();
  for (const int i : d.at_lower) directions.col(column++) = Eigen::VectorXd::Unit(n, i);
  for (const int i : d.at_upper) directions.col(column++) = -Eigen::VectorXd::Unit(n, i);
  const Eigen::VectorXd multipliers = directions.completeOrthogonalDecomposition().solve(gradient);
  EXPECT_LT((directions * multipliers - gradient).norm(), 1e-9 * (1.0 + gradient.norm()));
  const Eigen::Index limits = directions.cols() - p.matrix.rows();
  EXPECT_TRUE(limits == 0 || multipliers.tail(limits).minCoeff() > -1e-9 * (1.0 + gradient.norm()));
  for (const int i : d.at_lower) EXPECT_NEAR(d.tensions(i), p.lower(i), 1e-9);
  for (const int i : d.at_upper) EXPECT_NEAR(d.tensions(i), p.upper(i), 1e-9);
}

class Distribution : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Distribution, BalancesWithinLimitsAndIsOptimal) {
  Dice dice(51);
  int limited = 0;
  for (int i = 0; i < 200; ++i) {
    const TensionProblem p = randomProblem(GetParam().first, GetParam().second, &dice);
    const TensionDistribution d = distributeTensions(p);
    ASSERT_TRUE(d.feasible) << "problem " << i;
    EXPECT_LT((p.matrix * d.tensions - p.wrench).norm(), 1e-9);
    EXPECT_LT(d.imbalance, 1e-9);
    EXPECT_GE((d.tensions - p.lower).minCoeff(), -1e-9);
    EXPECT_GE((p.upper - d.tensions).minCoeff(), -1e-9);
    expectOptimal(p, d);
    limited += d.at_lower.empty() && d.at_upper.empty() ? 0 : 1;
  }
  EXPECT_TRUE(GetParam().second <= GetParam().first || limited > 20) << limited;
}

TEST_P(Distribution, IsTheSameFromTheRightLimits) {
  Dice dice(56);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const TensionProblem p = randomProblem(GetParam().first, GetParam().second, &dice);
    const TensionDistribution d = distributeTensions(p);
    const auto same = distributeAtLimits(p, d.at_lower, d.at_upper);
    if (!same) continue;
    ++found;
    EXPECT_TRUE(same->feasible);
    EXPECT_EQ(same->at_lower, d.at_lower);
    EXPECT_EQ(same->at_upper, d.at_upper);
    EXPECT_LT((same->tensions - d.tensions).norm(), 1e-9 * d.tensions.norm()) << "problem " << i;
  }
  EXPECT_TRUE(found > 150 || GetParam().second <= GetParam().first) << found;
}

TEST_P(Distribution, OtherLimitsAreNoAnswer) {
  Dice dice(57);
  for (int i = 0; i < 200; ++i) {
    const TensionProblem p = randomProblem(GetParam().first, GetParam().second, &dice);
    const TensionDistribution d = distributeTensions(p);
    for (int guess = 0; guess < GetParam().second; ++guess) {
      EXPECT_TRUE(d.at_lower == std::vector<int>{guess} || !distributeAtLimits(p, {guess}, {})) << i;
      EXPECT_TRUE(d.at_upper == std::vector<int>{guess} || !distributeAtLimits(p, {}, {guess})) << i;
    }
    EXPECT_TRUE((d.at_lower.empty() && d.at_upper.empty()) || !distributeAtLimits(p, {}, {})) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Distribution,
                         testing::Values(std::make_pair(6, 8), std::make_pair(6, 7), std::make_pair(6, 6),
                                         std::make_pair(3, 4), std::make_pair(3, 8), std::make_pair(3, 2)));

TEST(TensionDistribution, RankDeficientMatrixBalancesWhatItCan) {
  Dice dice(52);
  for (int i = 0; i < 100; ++i) {
    TensionProblem p = randomProblem(6, 8, &dice);
    // All cables in one plane: two rows vanish, one repeats another.
    p.matrix.row(1).setZero();
    p.matrix.row(3).setZero();
    p.matrix.row(5) = -2.0 * p.matrix.row(4);
    p.wrench = p.matrix * Eigen::VectorXd::Constant(8, 50.0);
    TensionDistribution d = distributeTensions(p);
    ASSERT_TRUE(d.feasible);
    EXPECT_LT(d.imbalance, 1e-9);
    EXPECT_LT((p.matrix * d.tensions - p.wrench).norm(), 1e-9);
    expectOptimal(p, d);
    p.wrench(1) = 7.0;
    d = distributeTensions(p);
    EXPECT_NEAR(d.imbalance, 7.0, 1e-9);
    EXPECT_NEAR((p.matrix * d.tensions - p.wrench).norm(), 7.0, 1e-9);
  }
}

TEST(TensionDistribution, RankDeficientMatrixIsNotSolvedAtLimits) {
  Dice dice(58);
  TensionProblem p = randomProblem(6, 8, &dice);
  p.matrix.row(5) = p.matrix.row(4);
  p.wrench(5) = p.wrench(4);
  EXPECT_FALSE(distributeAtLimits(p, {}, {}));
}

TEST(TensionDistribution, InfiniteLimitsDoNotLimit) {
  Dice dice(53);
  TensionProblem p = randomProblem(6, 8, &dice);
  p.lower.setConstant(-kInfinity);
  p.upper.setConstant(kInfinity);
  const TensionDistribution d = distributeTensions(p);
  ASSERT_TRUE(d.feasible);
  EXPECT_TRUE(d.at_lower.empty() && d.at_upper.empty());
  expectOptimal(p, d);
}

TEST(TensionDistribution, PreferredTensionsThatBalanceAreKept) {
  Dice dice(54);
  TensionProblem p = randomProblem(6, 8, &dice);
  p.preferred.setConstant(42.0);
  p.wrench = p.matrix * p.preferred;
  EXPECT_LT((distributeTensions(p).tensions - p.preferred).norm(), 1e-10);
}

TEST(TensionDistribution, ContradictingLimitsAreNamed) {
  // Two ropes hold 100 N between them; the first may carry 30 N, the second 40 N.
  TensionProblem p;
  p.matrix = Eigen::MatrixXd::Ones(1, 2);
  p.wrench = Eigen::VectorXd::Constant(1, 100.0);
  p.preferred = Eigen::Vector2d(20.0, 20.0);
  p.weight = Eigen::Vector2d::Ones();
  p.lower = Eigen::Vector2d::Zero();
  p.upper = Eigen::Vector2d(30.0, 40.0);
  const TensionDistribution d = distributeTensions(p);
  EXPECT_FALSE(d.feasible);
  EXPECT_TRUE(d.at_lower.empty());
  EXPECT_EQ(d.at_upper.size(), 2u);
}

// What is left of the wrench by the best of all sets of cables that pull.
double leastImbalance(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& wrench) {
  double least = wrench.norm();
  for (int set = 1; set < (1 << matrix.cols()); ++set) {
    std::vector<int> pulling;
    for (int i = 0; i < matrix.cols(); ++i) {
      if ((set >> i) & 1) pulling.push_back(i);
    }
    const Eigen::MatrixXd some = matrix(Eigen::all, pulling);
    if (some.cols() > some.rows()) continue;
    const Eigen::VectorXd t = some.colPivHouseholderQr().solve(wrench);
    if (t.minCoeff() >= 0.0) least = std::min(least, (some * t - wrench).norm());
  }
  return least;
}

TEST(TensionDistribution, NonNegativeTensionsBalanceAsWellAsAnyCan) {
  Dice dice(55);
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Eigen::MatrixXd matrix = randomMatrix(3, 5, &dice);
    const Eigen::VectorXd wrench = 50.0 * randomMatrix(3, 1, &dice);
    const Eigen::VectorXd t = nonNegativeTensions(matrix, wrench);
    EXPECT_GE(t.minCoeff(), 0.0);
    worst = std::max(worst, ((matrix * t - wrench).norm() - leastImbalance(matrix, wrench)) / wrench.norm());
  }
  EXPECT_LT(worst, 1e-8);
}

TEST(TensionDistribution, NonNegativeTensionsAreZeroWhereEveryCableWouldMakeItWorse) {
  const Eigen::VectorXd t = nonNegativeTensions(-Eigen::MatrixXd::Ones(1, 3), Eigen::VectorXd::Constant(1, 50.0));
  EXPECT_EQ(t.norm(), 0.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

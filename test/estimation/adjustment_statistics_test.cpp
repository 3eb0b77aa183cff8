// The statistics of an adjustment against dense normal equations and against drawn noise.
#include "estimation/adjustment_statistics.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr Eigen::Index kFreedoms = 6;

struct Problem {
  Adjusted adjusted;
  Eigen::MatrixXd load;
};

// Columns of the pose, then of the cables; their sizes differ as metres and newtons do.
Problem randomProblem(Eigen::Index cables, Eigen::Index rows, Dice* dice) {
  Problem problem;
  Eigen::MatrixXd& a = problem.adjusted.jacobian;
  a.resize(rows, kFreedoms + cables);
  problem.load.resize(kFreedoms, kFreedoms + cables);
  for (Eigen::Index column = 0; column < a.cols(); ++column) {
    const double size = std::exp(dice->uniform(-5.0, 5.0));
    for (Eigen::Index row = 0; row < rows; ++row) a(row, column) = size * dice->normal();
    for (Eigen::Index row = 0; row < kFreedoms; ++row) problem.load(row, column) = size * dice->normal();
  }
  for (Eigen::Index row = 0; row < rows; ++row) {
    problem.adjusted.observations.push_back(
        {Observation::Kind::kLength, static_cast<std::size_t>(row), dice->normal(), 0.0, row});
  }
  return problem;
}

TEST(AdjustmentStatistics, AreThoseOfTheNormalEquations) {
  Dice dice(71);
  for (int k = 0; k < 50; ++k) {
    const Eigen::Index cables = 3 + k % 6;
    Problem problem = randomProblem(cables, kFreedoms + cables + 1 + k % 7, &dice);
    const Eigen::MatrixXd a = problem.adjusted.jacobian;
    analyse(problem.load, &problem.adjusted);
    const Adjusted& adjusted = problem.adjusted;
    // With columns of unit length, as the normal equations would lose digits otherwise.
    const Eigen::VectorXd scale = a.colwise().norm().cwiseInverse();
    const Eigen::MatrixXd unit = a * scale.asDiagonal();
    const Eigen::MatrixXd normal = unit.transpose() * unit;
    const Eigen::MatrixXd inverse = normal.inverse();

    const Eigen::MatrixXd covariance = scale.head(kFreedoms).asDiagonal() *
                                       inverse.topLeftCorner(kFreedoms, kFreedoms) * scale.head(kFreedoms).asDiagonal();
    EXPECT_LT((adjusted.information * covariance - Eigen::MatrixXd::Identity(kFreedoms, kFreedoms)).norm(), 1e-7);
    const Eigen::MatrixXd expected_load =
        problem.load * scale.asDiagonal() * inverse * scale.asDiagonal() * problem.load.transpose();
    EXPECT_LT((adjusted.load_covariance - expected_load).norm(), 1e-8 * expected_load.norm());
    EXPECT_FALSE(adjusted.load_unknown.any());

    ASSERT_EQ(adjusted.observations.size(), static_cast<std::size_t>(a.rows()));
    EXPECT_EQ(adjusted.redundancy, a.rows() - a.cols());
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < adjusted.observations.size(); ++i) {
      const Eigen::RowVectorXd row = unit.row(static_cast<Eigen::Index>(i));
      EXPECT_NEAR(adjusted.observations[i].redundancy, 1.0 - row * inverse * row.transpose(), 1e-9);
      sum += adjusted.observations[i].redundancy;
      squares += adjusted.observations[i].residual * adjusted.observations[i].residual;
    }
    EXPECT_NEAR(sum, adjusted.redundancy, 1e-9);
    EXPECT_NEAR(adjusted.weighted_squares, squares, 1e-12 * squares);
  }
}

// Noise of unit deviation on every observation moves the pose as the information says.
TEST(AdjustmentStatistics, InformationPredictsDrawnErrors) {
  Dice dice(72);
  Problem problem = randomProblem(8, 22, &dice);
  analyse(problem.load, &problem.adjusted);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(problem.adjusted.jacobian);
  constexpr int kDraws = 4000;
  double squares = 0.0;
  for (int k = 0; k < kDraws; ++k) {
    Eigen::VectorXd noise(problem.adjusted.jacobian.rows());
    for (double& value : noise) value = dice.normal();
    const Eigen::VectorXd pose = Eigen::VectorXd(solver.solve(noise)).head(kFreedoms);
    squares += pose.dot(problem.adjusted.information * pose);
  }
  // Chi-square with 6 freedoms: the mean of 4000 has a deviation of 0.9 %.
  EXPECT_NEAR(squares / kDraws, kFreedoms, 0.04 * kFreedoms);
}

TEST(AdjustmentStatistics, LoadIsUnknownWhereItHangsOnWhatNothingFixes) {
  Dice dice(73);
  Problem problem = randomProblem(5, 14, &dice);
  problem.adjusted.jacobian.col(8).setZero();
  for (Eigen::Index k = 0; k < kFreedoms; ++k) {
    if (k != 2) problem.load(k, 8) = 0.0;
  }
  analyse(problem.load, &problem.adjusted);
  for (Eigen::Index k = 0; k < kFreedoms; ++k) EXPECT_EQ(problem.adjusted.load_unknown(k), k == 2) << k;
  EXPECT_EQ(problem.adjusted.redundancy, 14 - 10);
}

// Components of the load that are not known have rows of zeros.
TEST(AdjustmentStatistics, RowsOfZerosAreNoObservations) {
  Dice dice(74);
  Problem problem = randomProblem(4, 15, &dice);
  problem.adjusted.jacobian.row(3).setZero();
  analyse(problem.load, &problem.adjusted);
  ASSERT_EQ(problem.adjusted.observations.size(), 14U);
  EXPECT_EQ(problem.adjusted.observations[3].index, 4U);
  EXPECT_EQ(problem.adjusted.redundancy, 14 - 10);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Small quadratic programs: optimality by the Karush-Kuhn-Tucker conditions.
#include "robot/quadratic_program.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr SolveLimits::Clock::time_point kNoHurry = SolveLimits::Clock::time_point::max();

Eigen::MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, Dice* dice) {
  Eigen::MatrixXd m(rows, columns);
  for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = dice->uniform(-1.0, 1.0);
  return m;
}

// With 7 variables, 4 equations and 6 inequalities that an inner point satisfies.
QuadraticProgram randomProgram(Dice* dice) {
  QuadraticProgram p;
  const Eigen::MatrixXd root = randomMatrix(7, 7, dice);
  p.hessian = root.transpose() * root;
  p.gradient = 3.0 * randomMatrix(7, 1, dice);
  p.matrix = randomMatrix(4, 7, dice);
  p.normals = randomMatrix(7, 6, dice);
  const Eigen::VectorXd inside = randomMatrix(7, 1, dice);
  p.right = p.matrix * inside;
  p.bounds = p.normals.transpose() * inside - 0.1 * Eigen::VectorXd::Ones(6);
  p.scale = Eigen::VectorXd::LinSpaced(7, 0.1, 10.0);
  return p;
}

TEST(QuadraticProgram, SatisfiesTheKuhnTuckerConditions) {
  Dice dice(91);
  std::size_t active = 0;
  for (int i = 0; i < 200; ++i) {
    const QuadraticProgram p = randomProgram(&dice);
    const QuadraticStep step = solveQuadraticProgram(p, kNoHurry);
    ASSERT_TRUE(step.feasible) << i;
    EXPECT_LT((p.matrix * step.change - p.right).norm(), 1e-9);
    EXPECT_GT((p.normals.transpose() * step.change - p.bounds).minCoeff(), -1e-9);
    Eigen::VectorXd left = p.hessian * step.change + p.gradient - p.matrix.transpose() * step.multipliers;
    const Eigen::MatrixXd pushing = p.normals(Eigen::all, step.active);
    if (!step.active.empty()) {
      const Eigen::VectorXd pushes = pushing.colPivHouseholderQr().solve(left);
      EXPECT_GT(pushes.minCoeff(), -1e-8) << i;
      EXPECT_NEAR(step.largest_push, pushes.maxCoeff(), 1e-6 * (1.0 + pushes.maxCoeff()));
      left -= pushing * pushes;
    }
    EXPECT_LT(left.norm(), 1e-7 * (1.0 + p.gradient.norm())) << i;
    active += step.active.size();
  }
  EXPECT_GT(active, 50U);
}

// v in the plane v2 = 0, with negative curvature along v0: downhill, not to the saddle.
TEST(QuadraticProgram, GoesDownhillAlongNegativeCurvature) {
  QuadraticProgram p;
  p.hessian = Eigen::Vector3d(-2.0, 4.0, 1.0).asDiagonal();
  p.gradient = Eigen::Vector3d(1.0, 4.0, 0.0);
  p.matrix = Eigen::RowVector3d(0.0, 0.0, 1.0);
  p.right = Eigen::VectorXd::Zero(1);
  p.normals.resize(3, 0);
  p.bounds.resize(0);
  p.scale = Eigen::VectorXd::Ones(3);
  const QuadraticStep step = solveQuadraticProgram(p, kNoHurry);
  EXPECT_TRUE(step.change.isApprox(Eigen::Vector3d(-0.5, -1.0, 0.0), 1e-12)) << step.change.transpose();
}

TEST(QuadraticProgram, LeavesLittleWhereTheInequalitiesContradict) {
  QuadraticProgram p;
  p.hessian = Eigen::Matrix2d::Identity();
  p.gradient = Eigen::Vector2d::Zero();
  p.matrix = Eigen::RowVector2d(1.0, 1.0);
  p.right = Eigen::VectorXd::Constant(1, 10.0);
  p.normals = -Eigen::Matrix2d::Identity();
  p.bounds = Eigen::Vector2d(-1.0, -2.0);  // v <= (1, 2)
  p.scale = Eigen::VectorXd::Ones(2);
  const QuadraticStep step = solveQuadraticProgram(p, kNoHurry);
  EXPECT_FALSE(step.feasible);
  EXPECT_TRUE(step.change.isApprox(Eigen::Vector2d(1.0, 2.0), 1e-6)) << step.change.transpose();
  EXPECT_EQ(step.active.size(), 2U);
}

}  // namespace
}  // namespace cdpr_kinetostatics

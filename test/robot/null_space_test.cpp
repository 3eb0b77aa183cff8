// All solutions of linear equations, against the equations themselves.
#include "robot/null_space.h"

#include <gtest/gtest.h>

namespace cdpr_kinetostatics {
namespace {

// The third equation is the sum of the first two, but for its right side.
TEST(NullSpace, OfDependentEquationsThatContradictEachOther) {
  Eigen::MatrixXd matrix(3, 4);
  matrix << 1.0, 2.0, 0.0, -1.0, 0.0, 1.0, 3.0, 2.0, 1.0, 3.0, 3.0, 1.0;
  const Eigen::Vector3d met(4.0, -2.0, 2.0);
  const Eigen::Vector3d against = Eigen::Vector3d(1.0, 1.0, -1.0);  // orthogonal to the columns
  ASSERT_LT((matrix.transpose() * against).norm(), 1e-15);
  const NullSpace space = nullSpace(matrix, met + against);
  EXPECT_LT((matrix * space.particular - met).norm(), 1e-13);
  EXPECT_NEAR(space.imbalance, against.norm(), 1e-13);
  ASSERT_EQ(space.directions.cols(), 2);
  EXPECT_LT((matrix * space.directions).norm(), 1e-13);
  EXPECT_LT((space.directions.transpose() * space.directions - Eigen::Matrix2d::Identity()).norm(), 1e-13);
  EXPECT_LT((space.directions.transpose() * space.particular).norm(), 1e-13) << "the shortest solution";
}

TEST(NullSpace, IsEmptyWhereTheSolutionIsTheOnlyOne) {
  const Eigen::Matrix2d matrix = (Eigen::Matrix2d() << 2.0, 1.0, 0.0, 4.0).finished();
  const NullSpace space = nullSpace(matrix, Eigen::Vector2d(4.0, 8.0));
  EXPECT_EQ(space.directions.cols(), 0);
  EXPECT_LT((space.particular - Eigen::Vector2d(1.0, 2.0)).norm(), 1e-14);
  EXPECT_EQ(space.imbalance, 0.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

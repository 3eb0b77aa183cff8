#include "robot/null_space.h"

#include <Eigen/SVD>

namespace cdpr_kinetostatics {
namespace {

// Singular values below this share of the largest are zero: the unknowns cannot act in that direction.
constexpr double kRank = 1e-10;

}  // namespace

NullSpace nullSpace(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  const Eigen::Index rank = (values.array() > kRank * values(0)).count();
  const Eigen::VectorXd rotated = svd.matrixU().transpose() * right;
  NullSpace space;
  space.particular = svd.matrixV().leftCols(rank) * rotated.head(rank).cwiseQuotient(values.head(rank));
  space.directions = svd.matrixV().rightCols(matrix.cols() - rank);
  space.imbalance = rotated.tail(rotated.size() - rank).norm();
  return space;
}

}  // namespace cdpr_kinetostatics

// All solutions of a system of linear equations that may have too many unknowns, or equations that contradict each
// other.
#pragma once

#include <Eigen/Core>

namespace cdpr_kinetostatics {

struct NullSpace {
  Eigen::VectorXd particular;  // the shortest solution, in the least-squares sense
  Eigen::MatrixXd directions;  // orthonormal columns: what may be added to it
  double imbalance = 0.0;      // norm of what no unknowns can meet
};

// matrix * unknowns = right, by singular values.
NullSpace nullSpace(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace cdpr_kinetostatics

// Where a cable ends under given forces at A, and how that depends on forces and length.
#pragma once

#include <Eigen/Core>

namespace cdpr_kinetostatics {

struct EndPoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();                          // (x, y) [m]
  Eigen::Matrix<double, 2, 3> jacobian = Eigen::Matrix<double, 2, 3>::Zero();  // d(x, y)/d(H, V, L)
};

}  // namespace cdpr_kinetostatics

#include "cable/cable_description.h"

#include <Eigen/LU>
#include <cmath>

namespace cdpr_kinetostatics {

CableSolution solutionUnder(const CableProperties& cable, double length, const ForcesAtA& forces) {
  CableSolution solution;
  solution.status.code = Code::kConverged;
  solution.length = length;
  solution.free_length = length;
  solution.strained_length = length;
  solution.horizontal_force = forces.horizontal;
  solution.vertical_force_a = forces.vertical;
  solution.tension_a = forces.tension();
  solution.vertical_force_b = forces.vertical - cable.weight * length;
  solution.tension_b = std::hypot(forces.horizontal, solution.vertical_force_b);
  return solution;
}

Eigen::Matrix<double, 2, 3> forceJacobian(const EndPoint& end) {
  const Eigen::Matrix2d compliance = end.jacobian.leftCols<2>();
  Eigen::Matrix<double, 2, 3> jacobian;
  if (std::isinf(compliance(0, 0))) {  // a vertical loop: only its height acts, on V
    jacobian.setZero();
    jacobian(1, 1) = 1.0 / compliance(1, 1);
    jacobian(1, 2) = -end.jacobian(1, 2) / compliance(1, 1);
  } else {
    const Eigen::Matrix2d stiffness = compliance.inverse();
    jacobian << stiffness, -stiffness * end.jacobian.col(2);
  }
  zeroNonFinite(&jacobian);
  return jacobian;
}

void zeroNonFinite(Eigen::Matrix<double, 2, 3>* jacobian) {
  *jacobian = jacobian->unaryExpr([](double value) { return std::isfinite(value) ? value : 0.0; });
}

}  // namespace cdpr_kinetostatics

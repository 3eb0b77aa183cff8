#include "second_variation.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace cdpr_kinetostatics {

// Inertia of the tridiagonal matrix K by its pivots. With C the rows that move B, the index of K on the kernel of C is
// that of K less that of the compliance C K^-1 C^T (Haynsworth), to which stretch adds its own.
bool SecondVariation::stableWithEndsHeld() const {
  const std::size_t n = points_.size();
  std::vector<double> pivot(n);
  std::vector<Eigen::Vector2d> move(n);  // of B with beta at the point, then forward substituted
  int negative = 0;
  double off_last = 0.0;
  Eigen::Matrix2d compliance = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    const VariationPoint& p = points_[i];
    const double before = i > 0 ? p.s - points_[i - 1].s : 0.0;
    const double after = i + 1 < n ? points_[i + 1].s - p.s : 0.0;
    const double share = 0.5 * (before + after);
    const double off = i + 1 < n ? -lambda_squared_ / (0.5 * (p.e + points_[i + 1].e) * after) : 0.0;
    const Eigen::Vector2d along(std::cos(p.alpha), std::sin(p.alpha));
    const Eigen::Vector2d across(-along.y(), along.x());
    compliance += share * eps_ * along * along.transpose();
    move[i] = share * (p.e * across - eps_ * p.shear * along);
    pivot[i] = share * (p.e * p.tension - eps_ * p.shear * p.shear) - off - off_last;
    if (i > 0) {
      pivot[i] -= off_last * off_last / pivot[i - 1];
      move[i] -= off_last / pivot[i - 1] * move[i - 1];
    }
    compliance += move[i] * move[i].transpose() / pivot[i];
    if (pivot[i] < 0.0) ++negative;
    off_last = off;
  }
  const Eigen::Vector2d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(compliance).eigenvalues();
  return negative == (values.x() < 0.0 ? 1 : 0) + (values.y() < 0.0 ? 1 : 0);
}

}  // namespace cdpr_kinetostatics

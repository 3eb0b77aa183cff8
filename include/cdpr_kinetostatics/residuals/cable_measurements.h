// Ceres residual blocks of what is measured on a cable, in units of the standard deviation.
#pragma once

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>

namespace cdpr_kinetostatics {

// Parameter block: length 1, unstrained length L [m]. Residual: | (L - measured)/stddev |
class LengthMeasurement : public ceres::SizedCostFunction<1, 1> {
 public:
  LengthMeasurement(double measured, double stddev) : measured_(measured), stddev_(stddev) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const double measured_;
  const double stddev_;
};

// Parameter blocks: position 3, orientation 4, force 2 (H/x, V), as in cable_closure.h.
// Residual: | (sqrt((H/x)^2 x^2 + V^2) - measured)/stddev |, x the horizontal distance of A and B.
class TensionMeasurement : public ceres::SizedCostFunction<1, 3, 4, 2> {
 public:
  // anchor A [m], world; attachment b [m], platform frame.
  TensionMeasurement(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment, double measured,
                     double stddev);

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const Eigen::Vector3d anchor_;
  const Eigen::Vector3d attachment_;
  const double measured_;
  const double stddev_;
};

}  // namespace cdpr_kinetostatics

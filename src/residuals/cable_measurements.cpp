#include "cdpr_kinetostatics/residuals/cable_measurements.h"

#include <cmath>

#include "cdpr_kinetostatics/residuals/quaternion_rotation.h"

namespace cdpr_kinetostatics {

bool LengthMeasurement::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  residuals[0] = (parameters[0][0] - measured_) / stddev_;
  if (jacobians != nullptr && jacobians[0] != nullptr) jacobians[0][0] = 1.0 / stddev_;
  return true;
}

TensionMeasurement::TensionMeasurement(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment,
                                       double measured, double stddev)
    : anchor_(anchor), attachment_(attachment), measured_(measured), stddev_(stddev) {}

bool TensionMeasurement::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Map<const Eigen::Vector3d> position(parameters[0]);
  const Eigen::Map<const Eigen::Quaterniond> orientation(parameters[1]);
  const double density = parameters[2][0];
  const double vertical = parameters[2][1];
  Eigen::Vector3d horizontal = position + orientation * attachment_ - anchor_;
  horizontal.z() = 0.0;
  const double tension = std::hypot(density * horizontal.norm(), vertical);
  residuals[0] = (tension - measured_) / stddev_;
  if (jacobians == nullptr) return true;
  if (!(tension > 0.0)) return false;

  const double scale = 1.0 / (tension * stddev_);
  const Eigen::RowVector3d by_b = scale * density * density * horizontal.transpose();
  if (jacobians[0] != nullptr) Eigen::Map<Eigen::RowVector3d>{jacobians[0]} = by_b;
  if (jacobians[1] != nullptr) {
    Eigen::Map<Eigen::RowVector4d>{jacobians[1]} = by_b * rotationJacobian(orientation, attachment_);
  }
  if (jacobians[2] != nullptr) {
    jacobians[2][0] = scale * density * horizontal.squaredNorm();
    jacobians[2][1] = scale * vertical;
  }
  return true;
}

}  // namespace cdpr_kinetostatics

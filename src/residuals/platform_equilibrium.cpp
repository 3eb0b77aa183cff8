#include "cdpr_kinetostatics/residuals/platform_equilibrium.h"

#include <cmath>
#include <limits>

#include "cable/pulley_end.h"
#include "cable/rope_on_pulley.h"
#include "geometry/spatial.h"

namespace cdpr_kinetostatics {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The length of the part that hangs freely, and its derivative by (H, V, L).
struct FreeLength {
  double length = 0.0;
  Eigen::Vector3d by = Eigen::Vector3d::UnitZ();
};

FreeLength freeLength(const PlatformEquilibrium::Cable& cable, const ForcesAtA& forces, double length) {
  if (beginsAtEyelet(cable.properties)) return {length, Eigen::Vector3d::UnitZ()};
  CableProperties properties = cable.properties;
  properties.weight = cable.weight;
  const PulleyEnd at = pulleyEnd(properties, FreeShape::kCorrected, forces, length);
  const bool ends = at.free_length > 0.0 && at.free_length_by.allFinite();
  return {ends ? at.free_length : std::numeric_limits<double>::quiet_NaN(), at.free_length_by.transpose()};
}

}  // namespace

PlatformEquilibrium::PlatformEquilibrium(const Platform& platform, const std::vector<Cable>& cables,
                                         const Vector6& weight)
    : platform_(platform), cables_(cables), weight_(weight) {
  AddParameterBlock(3);
  AddParameterBlock(4);
  for (std::size_t i = 0; i < cables.size(); ++i) AddParameterBlock(2);
  for (std::size_t i = 0; i < cables.size(); ++i) AddParameterBlock(1);
  SetNumResiduals(platform.rigid_body ? 6 : 3);
}

bool PlatformEquilibrium::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Map<const Eigen::Vector3d> position(parameters[0]);
  const Eigen::Map<const Eigen::Quaterniond> orientation(parameters[1]);
  const int rows = num_residuals();
  const std::size_t count = cables_.size();

  const Eigen::Vector3d gravity(0.0, 0.0, -platform_.weight);
  const Eigen::Vector3d com = orientation * platform_.com;
  Vector6 total = platform_.external_wrench + wrenchAt(com, gravity);
  Eigen::Matrix<double, 6, 3> by_position = Eigen::Matrix<double, 6, 3>::Zero();
  Eigen::Matrix<double, 6, 4> by_orientation = Eigen::Matrix<double, 6, 4>::Zero();
  by_orientation.bottomRows<3>() = -cross(gravity) * rotationJacobian(orientation, platform_.com);

  for (std::size_t i = 0; i < count; ++i) {
    const Cable& cable = cables_[i];
    const double density = parameters[2 + i][0];
    const double vertical = parameters[2 + i][1];
    const double length = parameters[2 + count + i][0];
    const Eigen::Vector3d arm = orientation * cable.attachment;
    const Eigen::Vector3d to_b = position + arm - cable.anchor;
    const double x = to_b.head<2>().norm();
    const FreeLength free = freeLength(cable, {density * x, vertical}, length);
    if (!std::isfinite(free.length)) return false;
    const Eigen::Vector3d force(-density * to_b.x(), -density * to_b.y(), vertical - cable.weight * free.length);
    total += wrenchAt(arm, force);
    if (jacobians == nullptr) continue;

    const Eigen::Matrix3d arm_cross = cross(arm);
    Eigen::Matrix3d by_b = Eigen::Vector3d(-density, -density, 0.0).asDiagonal();
    const Eigen::Vector3d weight_by = -cable.weight * free.by;  // what it adds to the vertical force, by (H, V, L)
    if (weight_by.x() != 0.0) by_b.row(2).head<2>() = weight_by.x() * density / x * to_b.head<2>().transpose();
    const Eigen::Matrix<double, 3, 4> turn = rotationJacobian(orientation, cable.attachment);
    by_position.topRows<3>() += by_b;
    by_position.bottomRows<3>() += arm_cross * by_b;
    by_orientation.topRows<3>() += by_b * turn;
    by_orientation.bottomRows<3>() += arm_cross * by_b * turn - cross(force) * turn;
    if (jacobians[2 + i] != nullptr) {
      Eigen::Matrix<double, 6, 2> by_force;
      by_force.topRows<3>() << Eigen::Vector3d(-to_b.x(), -to_b.y(), weight_by.x() * x),
          (1.0 + weight_by.y()) * Eigen::Vector3d::UnitZ();
      by_force.bottomRows<3>() = arm_cross * by_force.topRows<3>();
      Eigen::Map<RowMajor>(jacobians[2 + i], rows, 2) = (weight_.asDiagonal() * by_force).topRows(rows);
    }
    if (jacobians[2 + count + i] != nullptr) {
      Vector6 by_length;
      by_length << 0.0, 0.0, weight_by.z(), weight_by.z() * arm_cross.col(2);
      Eigen::Map<Eigen::VectorXd>(jacobians[2 + count + i], rows) = (weight_.asDiagonal() * by_length).head(rows);
    }
  }
  Eigen::Map<Eigen::VectorXd>(residuals, rows) = (weight_.asDiagonal() * total).head(rows);
  if (jacobians == nullptr) return true;
  if (jacobians[0] != nullptr) {
    Eigen::Map<RowMajor>(jacobians[0], rows, 3) = (weight_.asDiagonal() * by_position).topRows(rows);
  }
  if (jacobians[1] != nullptr) {
    Eigen::Map<RowMajor>(jacobians[1], rows, 4) = (weight_.asDiagonal() * by_orientation).topRows(rows);
  }
  return true;
}

}  // namespace cdpr_kinetostatics

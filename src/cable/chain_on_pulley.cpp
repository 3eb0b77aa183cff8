#include "cable/chain_on_pulley.h"

#include "cable/rope_on_pulley.h"

namespace cdpr_kinetostatics {
namespace {

// Affine in (1, dh, dv, dl) of the chain to affine in (1, dH, dV, d(free length)), in SI units.
template <int kRows>
Eigen::Matrix<double, kRows, 4> inSi(const ShotCable& cable, const Eigen::Matrix<double, kRows, 4>& affine) {
  Eigen::Matrix<double, kRows, 4> result = affine;
  result.template middleCols<2>(1) /= cable.unit_force;
  result.col(3) /= cable.unit_length;
  return result;
}

}  // namespace

bool ChainOnPulley::link(const SegmentedCable& shape, const ShootingChain& chain, double length) {
  const ShotCable& cable = shape.cable;
  const double alpha = shape.segments.front().node.x();
  const HeldRope held = heldRope(cable.properties, {cable.force.x(), cable.force.y()}, alpha);
  const Eigen::RowVector4d angle = inSi<1>(cable, chain.change(0).row(0));

  // free length + held rope = L, linearised; its last column is that of the free length itself.
  const double slope = 1.0 + held.by_angle * angle[3];
  if (!(slope > 0.0)) return false;
  free_by_[0] = length - cable.length - held.length - held.by_angle * angle[0];
  free_by_.segment<2>(1) = -held.by_forces.transpose() - held.by_angle * angle.segment<2>(1);
  free_by_[3] = 1.0;
  free_by_ /= slope;

  Eigen::RowVector4d angle_by = angle[3] * free_by_;
  angle_by.head<3>() += angle.head<3>();
  const Eigen::Matrix<double, 2, 4> free_end = cable.unit_length * inSi<2>(cable, chain.end());
  Eigen::Matrix<double, 2, 4> end =
      free_end.col(3) * free_by_ + departureDerivative(cable.properties.pulley, alpha) * angle_by;
  end.leftCols<3>() += free_end.leftCols<3>();
  end_.position = departurePoint(cable.properties.pulley, alpha) + end.col(0);
  end_.jacobian = end.rightCols<3>();
  return end_.position.allFinite() && end_.jacobian.allFinite();
}

}  // namespace cdpr_kinetostatics

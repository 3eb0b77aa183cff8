#include "cdpr_kinetostatics/residuals/cable_closure.h"

#include <algorithm>
#include <cmath>

#include "cable/bending.h"
#include "cable/bending_expansion.h"
#include "cable/cable_evaluation.h"
#include "cable/straight.h"
#include "geometry/spatial.h"

namespace cdpr_kinetostatics {
namespace {

using RowMajor23 = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;
using RowMajor24 = Eigen::Matrix<double, 2, 4, Eigen::RowMajor>;
using RowMajor22 = Eigen::Matrix<double, 2, 2, Eigen::RowMajor>;

// B straight below A is taken this share of L0 beside it.
constexpr double kBeside = 1e-9;

}  // namespace

CableClosure::CableClosure(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment, double length_scale)
    : anchor_(anchor), attachment_(attachment), length_scale_(length_scale) {}

bool CableClosure::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Map<const Eigen::Vector3d> position(parameters[0]);
  const Eigen::Map<const Eigen::Quaterniond> orientation(parameters[1]);
  const double density = parameters[2][0];
  const double vertical = parameters[2][1];
  const double length = parameters[3][0];
  if (!(length > 0.0)) return false;

  Eigen::Vector3d to_b = position + orientation * attachment_ - anchor_;
  if (!to_b.allFinite()) return false;
  if (std::hypot(to_b.x(), to_b.y()) < kBeside * length_scale_) to_b.head<2>() << kBeside * length_scale_, 0.0;
  const double x = std::hypot(to_b.x(), to_b.y());
  EndPoint end;
  if (!endPoint(density * x, vertical, length, &end)) return false;
  residuals[0] = end.position.x() / x - 1.0;
  residuals[1] = (end.position.y() - to_b.z()) / length_scale_;
  if (jacobians == nullptr) return true;

  const Eigen::Vector2d scale(1.0 / x, 1.0 / length_scale_);
  const Eigen::Matrix<double, 2, 3> by_cable = scale.asDiagonal() * end.jacobian;
  RowMajor23 by_b;
  by_b.leftCols<2>() = by_cable.col(0) * density * to_b.head<2>().transpose() / x;
  by_b.row(0).head<2>() -= end.position.x() / (x * x * x) * to_b.head<2>().transpose();
  by_b.col(2) << 0.0, -1.0 / length_scale_;
  if (jacobians[0] != nullptr) Eigen::Map<RowMajor23>{jacobians[0]} = by_b;
  if (jacobians[1] != nullptr) {
    Eigen::Map<RowMajor24>{jacobians[1]} = by_b * rotationJacobian(orientation, attachment_);
  }
  if (jacobians[2] != nullptr) {
    Eigen::Map<RowMajor22> by_force(jacobians[2]);
    by_force << by_cable.col(0) * x, by_cable.col(1);
  }
  if (jacobians[3] != nullptr) Eigen::Map<Eigen::Vector2d>{jacobians[3]} = by_cable.col(2);
  return true;
}

std::unique_ptr<CableClosure> makeClosure(Model model, const CableProperties& cable, const Eigen::Vector3d& anchor,
                                          const Eigen::Vector3d& attachment, double length_scale,
                                          const SolveLimits& options) {
  const CableProperties seen = asSeenBy(model, cable);
  if (isStraight(model)) return std::make_unique<StraightClosure>(seen, anchor, attachment, length_scale);
  if (isBending(model) && seen.bending_stiffness > 0.0) {
    return std::make_unique<BendingClosure>(seen, anchor, attachment, length_scale, options);
  }
  return std::make_unique<CatenaryClosure>(seen, anchor, attachment, length_scale);
}

StraightClosure::StraightClosure(const CableProperties& cable, const Eigen::Vector3d& anchor,
                                 const Eigen::Vector3d& attachment, double length_scale)
    : CableClosure(anchor, attachment, length_scale), cable_(cable) {}

bool StraightClosure::endPoint(double h, double v, double length, EndPoint* end) const {
  *end = straightEnd(cable_, h, v, length);
  return end->position.allFinite() && end->jacobian.allFinite();
}

CatenaryClosure::CatenaryClosure(const CableProperties& cable, const Eigen::Vector3d& anchor,
                                 const Eigen::Vector3d& attachment, double length_scale)
    : CableClosure(anchor, attachment, length_scale), cable_(cable) {}

bool CatenaryClosure::endPoint(double h, double v, double length, EndPoint* end) const {
  if (!(h > 0.0)) return false;
  *end = correctedCatenaryEnd(cable_, h, v, length);
  return end->position.allFinite() && end->jacobian.allFinite();
}

BendingClosure::BendingClosure(const CableProperties& cable, const Eigen::Vector3d& anchor,
                               const Eigen::Vector3d& attachment, double length_scale, const SolveLimits& options)
    : CableClosure(anchor, attachment, length_scale), cable_(cable), options_(options) {}

bool BendingClosure::endPoint(double h, double v, double length, EndPoint* end) const {
  const ForcesAtA forces{h, v};
  started_ = (started_ && followBendingPosition(length, forces, options_, &shooting_).status.ok()) ||
             solveBendingPosition(cable_, length, forces, options_, &shooting_).status.ok();
  if (!started_) return false;
  *end = shooting_.end();
  return true;
}

}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/residuals/cable_closure.h"

#include <cmath>

#include "cable/bending.h"
#include "cable/sagging_cable.h"
#include "geometry/cable_plane.h"
#include "geometry/spatial.h"

namespace cdpr_kinetostatics {
namespace {

using RowMajor23 = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;
using RowMajor24 = Eigen::Matrix<double, 2, 4, Eigen::RowMajor>;
using RowMajor22 = Eigen::Matrix<double, 2, 2, Eigen::RowMajor>;

}  // namespace

// Where the cable ends under forces at A, whatever its model.
class CableClosure::CableEnd {
 public:
  CableEnd(Model model, const CableProperties& cable, const SolveLimits& limits)
      : properties_(asSeenBy(model, cable)),
        bends_(isBending(model) && properties_.bending_stiffness > 0.0),
        limits_(limits),
        closed_form_(cable, model, limits.tolerance) {}

  // False where the cable has no equilibrium under these forces, or none was found.
  bool find(const ForcesAtA& forces, double length, EndPoint* end) {
    if (bends_) {
      started_ = (started_ && followBendingPosition(length, forces, limits_, &shooting_).status.ok()) ||
                 solveBendingPosition(properties_, length, forces, limits_, &shooting_).status.ok();
      if (started_) *end = shooting_.end();
      return started_;
    }
    if (!(forces.horizontal > 0.0)) return false;
    closed_form_.start(length, forces);
    if (!closed_form_.linearise(false)) return false;
    *end = closed_form_.end();
    return true;
  }

 private:
  const CableProperties properties_;
  const bool bends_;
  const SolveLimits limits_;
  SaggingCable closed_form_;
  MultipleShooting shooting_;
  bool started_ = false;
};

CableClosure::CableClosure(Model model, const CableProperties& cable, const Eigen::Vector3d& anchor,
                           const Eigen::Vector3d& attachment, double length_scale, const SolveLimits& limits)
    : anchor_(anchor),
      attachment_(attachment),
      length_scale_(length_scale),
      end_(std::make_unique<CableEnd>(model, cable, limits)) {}

CableClosure::~CableClosure() = default;

bool CableClosure::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Quaterniond orientation(parameters[1]);
  const double density = parameters[2][0];
  const double vertical = parameters[2][1];
  const double length = parameters[3][0];
  if (!(length > 0.0)) return false;

  const Pose pose{Eigen::Vector3d(parameters[0]), orientation};
  Eigen::Vector3d to_b = anchorToAttachment(anchor_, attachment_, pose);
  if (!to_b.allFinite()) return false;
  const double beside = std::hypot(to_b.x(), to_b.y());
  const double x = distanceBeside(beside, length_scale_);
  if (x > beside) to_b.head<2>() << x, 0.0;
  EndPoint end;
  if (!end_->find({density * x, vertical}, length, &end)) return false;
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
  if (jacobians[2] != nullptr) Eigen::Map<RowMajor22>{jacobians[2]} << by_cable.col(0) * x, by_cable.col(1);
  if (jacobians[3] != nullptr) Eigen::Map<Eigen::Vector2d>{jacobians[3]} = by_cable.col(2);
  return true;
}

std::unique_ptr<CableClosure> makeClosure(Model model, const CableProperties& cable, const Eigen::Vector3d& anchor,
                                          const Eigen::Vector3d& attachment, double length_scale,
                                          const SolveLimits& limits) {
  return std::make_unique<CableClosure>(model, cable, anchor, attachment, length_scale, limits);
}

}  // namespace cdpr_kinetostatics

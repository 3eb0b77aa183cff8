// Ceres residual blocks that close a cable: its end under the forces at A is where the platform holds it.
//
// Parameter blocks, in this order:
//   position     3   platform origin, world [m]
//   orientation  4   unit quaternion x y z w, platform to world (ceres::EigenQuaternionManifold)
//   force        2   (H/x, V): horizontal force density [N/m] and vertical force at A [N]
//   length       1   unstrained length L [m]
//
// Residual, dimensionless, with B = p + R b, h = B - A (horizontal part), x = |h|:
//
//     | x_cable(H, V, L)/x - 1          |
//     | (w_cable(H, V, L) - (B - A)_z)/L0 |      L0: the length the block is made with
//
// The force density H/x rather than H keeps the block smooth where B lies straight below A: there the
// direction of the cable's plane does not exist, but H/x does (docs/theory.md section 5).
#pragma once

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <memory>

#include "cable/bending.h"
#include "cable/multiple_shooting.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/end_point.h"
#include "cdpr_kinetostatics/cable/model.h"

namespace cdpr_kinetostatics {

class CableClosure : public ceres::SizedCostFunction<2, 3, 4, 2, 1> {
 public:
  // anchor A [m], world; attachment b [m], platform frame; length_scale L0 [m].
  CableClosure(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment, double length_scale);

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  // False where the cable cannot be evaluated: the solver's step is rejected.
  virtual bool endPoint(double horizontal_force, double vertical_force_a, double length, EndPoint* end) const = 0;

  const Eigen::Vector3d anchor_;
  const Eigen::Vector3d attachment_;
  const double length_scale_;
};

// The block of a rung of the ladder; options are those of the bending rungs, which refuse after the deadline.
std::unique_ptr<CableClosure> makeClosure(Model model, const CableProperties& cable, const Eigen::Vector3d& anchor,
                                          const Eigen::Vector3d& attachment, double length_scale,
                                          const SolveLimits& options);

// The straight line with half the cable's weight at each end; an infinite axial stiffness is the inextensible
// one. Not for slack cables.
class StraightClosure : public CableClosure {
 public:
  StraightClosure(const CableProperties& cable, const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment,
                  double length_scale);

 private:
  bool endPoint(double horizontal_force, double vertical_force_a, double length, EndPoint* end) const override;

  const CableProperties cable_;
};

// The catenary in closed form; an infinite axial stiffness is the inextensible one, a bending stiffness adds its
// first-order effect.
class CatenaryClosure : public CableClosure {
 public:
  CatenaryClosure(const CableProperties& cable, const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment,
                  double length_scale);

 private:
  bool endPoint(double horizontal_force, double vertical_force_a, double length, EndPoint* end) const override;

  const CableProperties cable_;
};

// The bending cable, integrated by RK45 multiple shooting; its nodes are eliminated inside. The shape of
// the last evaluation is where the next one starts, so a block must not be evaluated by two threads at once.
class BendingClosure : public CableClosure {
 public:
  BendingClosure(const CableProperties& cable, const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment,
                 double length_scale, const SolveLimits& options);

 private:
  bool endPoint(double horizontal_force, double vertical_force_a, double length, EndPoint* end) const override;

  const CableProperties cable_;
  const SolveLimits options_;
  mutable MultipleShooting shooting_;
  mutable bool started_ = false;
};

}  // namespace cdpr_kinetostatics

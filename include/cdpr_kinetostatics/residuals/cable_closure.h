// Ceres residual block that closes a cable of any model: its end under the forces at A is where the platform holds it.
//
// Parameter blocks, in this order:
//   position     3   platform origin, world [m]
//   orientation  4   unit quaternion x y z w, platform to world (ceres::EigenQuaternionManifold)
//   force        2   (H/x, V): horizontal force density [N/m] and vertical force at A [N]
//   length       1   unstrained length L [m]
//
// Residual, dimensionless, with B = p + R b, h = B - A (horizontal part), x = |h|:
//
//     | x_cable(H, V, L)/x - 1            |
//     | (y_cable(H, V, L) - (B - A)_z)/L0 |      L0: the length that the block is made with
//
// (x, y)_cable, the end in the cable's plane, is a closed form for catenaries; a bending cable is integrated by
// Runge-Kutta shots, whose nodes are solved for inside. The density H/x rather than H keeps the block smooth where B
// lies straight below A: there the direction of the cable's plane does not exist, but H/x does (docs/theory.md
// section 5).
#pragma once

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <memory>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

// A bending cable's shape at the last evaluation is where the next one starts, so a block must not be evaluated by two
// threads at once.
class CableClosure : public ceres::SizedCostFunction<2, 3, 4, 2, 1> {
 public:
  // model: one of the sagging ones. anchor A [m], world; attachment b [m], platform frame; length_scale L0 [m]. limits
  // are those of bending cables.
  CableClosure(Model model, const CableProperties& cable, const Eigen::Vector3d& anchor,
               const Eigen::Vector3d& attachment, double length_scale, const SolveLimits& limits = SolveLimits());
  ~CableClosure() override;

  // False where the cable cannot be evaluated, and for bending cables after the deadline: a solver then rejects its
  // step.
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  class CableEnd;

  const Eigen::Vector3d anchor_;
  const Eigen::Vector3d attachment_;
  const double length_scale_;
  const std::unique_ptr<CableEnd> end_;
};

std::unique_ptr<CableClosure> makeClosure(Model model, const CableProperties& cable, const Eigen::Vector3d& anchor,
                                          const Eigen::Vector3d& attachment, double length_scale,
                                          const SolveLimits& limits);

// The catenary in closed form; an infinite axial stiffness is the inextensible one, a bending stiffness adds its
// first-order effect.
class CatenaryClosure : public CableClosure {
 public:
  CatenaryClosure(const CableProperties& cable, const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment,
                  double length_scale)
      : CableClosure(Model::kCatenaryCorrected, cable, anchor, attachment, length_scale) {}
};

// The bending cable, by the ordinary differential equation; without bending stiffness the catenary.
class BendingClosure : public CableClosure {
 public:
  BendingClosure(const CableProperties& cable, const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment,
                 double length_scale, const SolveLimits& limits)
      : CableClosure(Model::kBending, cable, anchor, attachment, length_scale, limits) {}
};

}  // namespace cdpr_kinetostatics

// Ceres residual block of everything measured on a platform at rest, with closure kept exactly inside.
//
// Parameter blocks, in this order:
//   position     3   platform origin, world [m]
//   orientation  4   unit quaternion x y z w, platform to world (ceres::EigenQuaternionManifold)
//   density      n   H/x of each cable: horizontal force over horizontal distance [N/m]
//
// V_i and L_i of each cable follow from closure (residuals/closed_cable.h); a bending cable is integrated. Residuals,
// with F_i the cables' forces (31) and T_A,i = hypot(H_i, V_i):
//
//     | (L_i - measured)/deviation                        |  one row per cable with a measured length, then
//     | (T_A,i - measured)/deviation                      |  one row per cable with a measured tension, then
//     | (sum F_i + m g + f_ext) * weight (first three)    |  if any component of the load is known; a point mass
//     | (sum R b_i x F_i + R c x m g + m_ext) * weight    |  has the first three alone
//
// weight is one over the deviation of that component of the load, 0 where it is not known.
#pragma once

#include <ceres/dynamic_cost_function.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/geometry/pose.h"
#include "cdpr_kinetostatics/residuals/platform_equilibrium.h"
#include "residuals/closed_cable.h"

namespace cdpr_kinetostatics {

// The wrench that is left over on the platform, of cables, weight and external wrench, and how it changes.
struct LoadBalance {
  Wrench total;
  Eigen::Matrix<double, 6, 6> by_pose;  // (translation, rotation vector), at constant densities
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_density;
};

// Keeps each cable's shape from one evaluation to the next, so it must not be evaluated by two threads at once.
class PlatformMeasurements : public ceres::DynamicCostFunction {
 public:
  using Platform = PlatformEquilibrium::Platform;
  struct Measured {
    double value = 0.0;
    double deviation = 1.0;  // standard deviation
  };
  struct Cable {
    Eigen::Vector3d anchor;      // A [m], world
    Eigen::Vector3d attachment;  // b [m], platform frame
    SaggingCable start;          // where closure is first looked for
    std::optional<Measured> length, tension;
  };

  // load_weight [1/N, 1/(N m)]; limits: of closure. After the deadline no bending cable is closed any more.
  PlatformMeasurements(const Platform& platform, const std::vector<Cable>& cables, const Wrench& load_weight,
                       const SolveLimits& limits);

  // False where a cable cannot be closed or numbers overflow: a solver then rejects its step.
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

  // As of the last evaluation, which must have succeeded.
  const std::vector<ClosedCable>& cables() const { return cables_; }
  LoadBalance loadBalance() const;
  // d(total)/d(translation, rotation vector) at constant lengths.
  Eigen::Matrix<double, 6, 6> stiffness(const LoadBalance& balance) const;

 private:
  struct Rows;

  bool closeAll(double const* const* parameters) const;
  void addLengths(Rows* rows) const;
  void addTensions(Rows* rows) const;
  void addLoad(Rows* rows) const;

  const Platform platform_;
  std::vector<std::optional<Measured>> lengths_, tensions_;
  const Wrench load_weight_;
  mutable std::vector<ClosedCable> cables_, before_;
  mutable Pose pose_;                      // of the last evaluation
  mutable std::vector<double> closed_at_;  // its parameters; empty if it failed
};

}  // namespace cdpr_kinetostatics

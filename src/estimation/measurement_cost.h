// Ceres residual block of everything measured on a robot, with closure kept exactly.
//
// Parameter blocks, in this order:
//   position     3   platform origin, world [m]
//   orientation  4   unit quaternion x y z w, platform to world (ceres::EigenQuaternionManifold)
//   density      n   H/x of each cable: horizontal force over horizontal distance [N/m]
//
// At a pose, H determines V and L by closure, uniquely and smoothly: also at the fold where the tension at A
// is least and a length could not be told from it. Residuals, one for each selected measurement:
//
//     | (L_i - measured)/length_stddev       |  cables with a length
//     | (T_A,i - measured)/tension_stddev    |  cables with a tension
//     | (sum of wrenches, weight)/load_stddev |  6 (point mass: 3) rows if any component of the load is known;
//                                               components that are not known are zero
#pragma once

#include <ceres/dynamic_cost_function.h>

#include <Eigen/Core>
#include <vector>

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {

// The wrench that is left over on the platform, cables and weight, and how it changes.
struct LoadBalance {
  Wrench total;
  Eigen::Matrix<double, 6, 6> by_pose;  // (translation, rotation vector), at constant densities
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_density;
};

// Keeps each cable's shape from one evaluation to the next, so it must not be evaluated by two threads at once.
class MeasurementCost : public ceres::DynamicCostFunction {
 public:
  // All arguments must outlive the block; start gives the shapes to begin with.
  MeasurementCost(const RobotDescription& robot, const EstimatorOptions& options, const CableMeasurements& measurements,
                  const Selection& selection, const std::vector<Model>& rungs, const RobotForces& start);

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

  // As of the last evaluation, which was at this pose and these densities.
  const std::vector<SaggingCable>& cables() const { return cables_; }
  LoadBalance loadBalance(const Pose& pose, const double* densities) const;
  // d(total)/d(translation, rotation vector) at constant lengths.
  Eigen::Matrix<double, 6, 6> stiffness(const LoadBalance& balance) const;

 private:
  // (H, V, L) of a cable change by by_pose * (translation, rotation vector) + by_density * change.
  struct Sensitivity {
    CablePlane plane;
    Eigen::Matrix<double, 3, 6> by_pose;
    Eigen::Vector3d by_density;
  };

  bool close(std::size_t i, const Pose& pose, double density) const;
  bool closeAll(const Pose& pose, double const* const* parameters) const;

  const RobotDescription& robot_;
  const EstimatorOptions& options_;
  const CableMeasurements& measurements_;
  const Selection& selection_;
  mutable std::vector<SaggingCable> cables_, before_;
  mutable std::vector<Sensitivity> sensitivities_;
  mutable bool linearised_ = false;        // all cables, at the last evaluation
  mutable std::vector<double> closed_at_;  // parameters of the last evaluation; empty if that failed
};

}  // namespace cdpr_kinetostatics

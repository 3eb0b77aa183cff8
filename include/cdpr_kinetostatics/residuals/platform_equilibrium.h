// Ceres residual block: the cables' forces, the platform's weight and an external wrench balance.
//
// Parameter blocks, in this order:
//   position     3   platform origin, world [m]
//   orientation  4   unit quaternion x y z w, platform to world (ceres::EigenQuaternionManifold)
//   force        2   (H/x, V) of cable 0 [N/m, N], then of cable 1, ...
//   length       1   unstrained length of cable 0 [m], then of cable 1, ...
//
// Residual, with F_i = (-(H/x)_i h_i, V_i - q_i L_f,i), h_i the horizontal part of B_i - A_i, and L_f,i the part of L_i
// that hangs freely: all of it, or, where there is a guide pulley, what leaves it as in CATENARY_CORRECTED:
//
//     | (sum F_i + m g + f_ext) * weight (first three)                |
//     | (sum R b_i x F_i + R c x m g + m_ext) * weight (last three)    |    rigid bodies only
#pragma once

#include <ceres/dynamic_cost_function.h>

#include <Eigen/Core>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

class PlatformEquilibrium : public ceres::DynamicCostFunction {
 public:
  struct Cable {
    Eigen::Vector3d anchor;      // A [m], world
    Eigen::Vector3d attachment;  // b [m], platform frame
    double weight = 0.0;         // q [N/m]
    // What else the free length depends on where there is a guide pulley or a dead part; the weight here is not read.
    CableProperties properties = {};
  };
  struct Platform {
    bool rigid_body = true;                       // false: a point mass, three residuals
    double weight = 0.0;                          // m g [N]
    Eigen::Vector3d com;                          // c [m], platform frame
    Eigen::Matrix<double, 6, 1> external_wrench;  // force, torque about the origin, world axes
  };

  // weight multiplies the residuals, component by component [1/N, 1/(N m)].
  PlatformEquilibrium(const Platform& platform, const std::vector<Cable>& cables,
                      const Eigen::Matrix<double, 6, 1>& weight);

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const Platform platform_;
  const std::vector<Cable> cables_;
  const Eigen::Matrix<double, 6, 1> weight_;
};

}  // namespace cdpr_kinetostatics

// What bending stiffness does to a cable where it leaves a guide pulley, in closed form, (45) and (46) of
// docs/theory.md: the bending layer in which the pulley's curvature dies out.
#pragma once

#include <Eigen/Core>

#include "cable/forces_at_a.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

struct PulleyLayer {
  double thickness = 0.0;                           // lambda [m]
  double turn = 0.0;                                // slope where the rope leaves less that of the force [rad]
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  // of all that lies beyond the layer, from where the rope leaves [m]
  Eigen::Vector2d beyond = Eigen::Vector2d::Zero();         // the largest part of what the shift leaves out, (47) [m]
  Eigen::RowVector2d turn_by = Eigen::RowVector2d::Zero();  // by (H, V)
  Eigen::Matrix2d shift_by = Eigen::Matrix2d::Zero();
};

// All zero without pulley or bending stiffness. Not finite where no layer brings the cable to the pulley's curvature:
// it lifts off long before. Needs a tension.
PulleyLayer pulleyLayer(const CableProperties& cable, const ForcesAtA& forces);

}  // namespace cdpr_kinetostatics

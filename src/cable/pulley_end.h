// Where a cable in closed form ends that comes from a guide pulley or has a dead part, (43) of docs/theory.md: a
// straight line or a catenary from the point where the rope leaves the pulley; a corrected one with the layer there,
// (46).
#pragma once

#include <Eigen/Core>

#include "cable/forces_at_a.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/end_point.h"

namespace cdpr_kinetostatics {

// The shape of the free part: a line with half of the weight at each end, the catenary, or that with the first-order
// effect of bending.
enum class FreeShape { kStraight, kCatenary, kCorrected };

struct PulleyEnd {
  EndPoint end;                                              // from A0, with its derivatives by (H, V, L)
  double angle = 0.0;                                        // alpha [rad]
  double free_length = 0.0;                                  // unstrained [m]
  Eigen::RowVector3d angle_by = Eigen::RowVector3d::Zero();  // of both by (H, V, L)
  Eigen::RowVector3d free_length_by = Eigen::RowVector3d::Zero();
};

// The end of the free part alone, from where it begins.
EndPoint freeEnd(const CableProperties& cable, FreeShape shape, const ForcesAtA& forces, double free_length);

// Needs H >= 0 and a tension; its numbers are not finite, or the free length is not positive, where there is no end.
PulleyEnd pulleyEnd(const CableProperties& cable, FreeShape shape, const ForcesAtA& forces, double length);

}  // namespace cdpr_kinetostatics

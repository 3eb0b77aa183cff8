// What flexural rigidity does to a catenary, in closed form up to a quadrature: what CATENARY_CORRECTED adds, and the
// estimate of what the models below BENDING leave out (docs/theory.md section 4).
//
// Conventions of docs/conventions.md: forces (H, V) at A, unstrained length L, end (x, y).
#pragma once

#include <Eigen/Core>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/end_point.h"

namespace cdpr_kinetostatics {

// Displacement of the end to first order in EI, equation (24), with its derivatives. Needs H > 0, or a
// cable under tension along a vertical (H = 0, V outside [0, q L]).
EndPoint firstOrderBending(const CableProperties& cable, double horizontal_force, double vertical_force_a,
                           double length);

// Displacement of the end by bending with the end layers' own effect, equations (24) and (29).
struct BendingExpansion {
  Eigen::Vector2d end = Eigen::Vector2d::Zero();           // of the bending cable from the catenary [m]
  Eigen::Vector2d beyond_first = Eigen::Vector2d::Zero();  // the part that firstOrderBending lacks [m]
  bool trusted = false;  // false where the expansion does not hold: sharp slack bends, compression
};
BendingExpansion bendingExpansion(const CableProperties& cable, double horizontal_force, double vertical_force_a,
                                  double length);

}  // namespace cdpr_kinetostatics

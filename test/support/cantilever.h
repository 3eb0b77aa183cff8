// A clamped beam with a dead force at its free end, on the integrator of the bending cable: the exact cases
// of the literature are cantilevers.
#pragma once

#include "cable/shot.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

struct Cantilever {
  CableProperties beam;
  double length = 0.0;              // [m]
  double tip_x = 0.0, tip_w = 0.0;  // dead force at the free end [N]
};

struct CantileverTip {
  bool solved = false;
  double x = 0.0, y = 0.0;    // [m], clamped horizontally at the origin
  double alpha = 0.0;         // slope [rad]
  double clamp_moment = 0.0;  // [N m]
};

// Newton's method on the moment at the clamp, with the shot's own sensitivities.
CantileverTip solveCantilever(const Cantilever& cantilever, double tolerance);

}  // namespace cdpr_kinetostatics

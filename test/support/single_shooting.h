// What one would write first for problem 2: integrate from A to B in one shot and correct (alpha_A, H, V) by Newton's
// method from the catenary. The baseline of the stability map; why it fails is in docs/theory.md section 3.
#pragma once

#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

struct SingleShooting {
  bool converged = false;   // moment at B and end point are met to the tolerance
  double h = 0.0, v = 0.0;  // [N]
  double angle_a = 0.0;     // [rad]
  int iterations = 0;
};

SingleShooting shootSingly(const CableProperties& cable, double length, double x, double y, double tolerance);

}  // namespace cdpr_kinetostatics

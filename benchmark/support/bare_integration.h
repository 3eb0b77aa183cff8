// The yardstick of the speed of bending cables: a plain adaptive RK45 pass along a cable that is already known.
//
// Dormand and Prince's pair on (alpha, M, x, y) alone, without sensitivities, first same as last, sine and cosine
// once per evaluation. Steps are held only by the tolerance and by stability; the last step size is carried on.
#pragma once

#include <vector>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"

namespace cdpr_kinetostatics {

// A converged cable with the states from which the integration starts anew: a whole cable in one go would leave
// its solution like exp(kappa L).
struct KnownCable {
  CableProperties properties;
  double length = 0.0;            // [m]
  double horizontal_force = 0.0;  // [N]
  double vertical_force_a = 0.0;  // [N]
  std::vector<ProfilePoint> nodes;
};

struct BarePass {
  int steps = 0;
  double x = 0.0;          // of the end B [m]
  double y = 0.0;          // [m]
  double departure = 0.0;  // largest difference of the angle from the next node [rad]
};

// tolerance: largest error of alpha [rad] and of M [in units of sqrt(EI T)] in one step.
BarePass integrateBare(const KnownCable& cable, double tolerance);

// Bending layers in the cable at its larger end tension.
double layersOf(const KnownCable& cable);

// Nodes no farther apart than so many bending layers.
int nodesFor(const KnownCable& cable, double layers_between);

}  // namespace cdpr_kinetostatics

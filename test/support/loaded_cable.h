// Random cables under given forces: what the effect of bending is tested on.
#pragma once

#include <algorithm>
#include <cmath>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {

// From taut to hanging, from a few bending layers to a thousand.
struct LoadedCable {
  CableProperties cable;
  double length = 0.0, h = 0.0, v = 0.0;
};

inline LoadedCable randomLoaded(Dice* dice, double most_sag) {
  const auto power = [&](double low, double high) { return std::pow(10.0, dice->uniform(low, high)); };
  LoadedCable c;
  c.length = power(0.0, 2.0);
  c.cable.weight = power(-1.0, 1.0);
  const double tension = c.cable.weight * c.length / power(-3.0, most_sag);
  const double angle = dice->uniform(-1.4, 1.4);
  c.h = tension * std::cos(angle);
  c.v = tension * std::sin(angle) + 0.5 * c.cable.weight * c.length;
  c.cable.axial_stiffness = std::max(tension, c.cable.weight * c.length) / power(-6.0, -2.0);
  c.cable.bending_stiffness = std::hypot(c.h, c.v) * std::pow(c.length / power(0.5, 3.0), 2);
  return c;
}

}  // namespace cdpr_kinetostatics

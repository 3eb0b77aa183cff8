// Cables that several tests speak of.
#pragma once

#include <cmath>
#include <limits>

#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInextensible = std::numeric_limits<double>::infinity();

// The paper's solid bar: radius 1 cm, E = 170 GPa, 8050 kg/m^3, g = 9.81 m/s^2.
inline CableProperties paperBar() {
  const double radius = 0.01;
  const double area = kPi * radius * radius;
  return {170e9 * area, 170e9 * kPi * std::pow(radius, 4) / 4.0, 8050.0 * 9.81 * area};
}

// A 4 mm steel rope of the robot CoGiRo.
inline CableProperties steelRope() { return {2.87e5, 0.44, 0.064 * 9.81}; }

}  // namespace cdpr_kinetostatics

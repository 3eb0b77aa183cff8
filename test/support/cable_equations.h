// The bending cable's equations as the paper writes them (docs/theory.md section 1), in SI units, for any
// scalar type, with the plainest integrator there is: what the package's own integrator is compared with.
#pragma once

#include <array>
#include <cmath>

#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

template <typename T>
using CableState = std::array<T, 4>;  // alpha, M, x, y

template <typename T>
CableState<T> cableSlope(const CableProperties& cable, const T& h, const T& v, const T& s, const CableState<T>& y) {
  using std::cos;
  using std::sin;
  const T c = cos(y[0]);
  const T n = sin(y[0]);
  const T tension = h * c + (cable.weight * s - v) * n;
  const T shear = h * n + (v - cable.weight * s) * c;
  const T e = 1.0 + tension / cable.axial_stiffness;
  return {e * y[1] / cable.bending_stiffness, e * shear, e * c, e * n};
}

// Classical fourth-order Runge-Kutta steps of equal length from s = from to s = to.
template <typename T>
CableState<T> integrateCable(const CableProperties& cable, const T& h, const T& v, const T& from, const T& to,
                             CableState<T> y, int steps) {
  const T ds = (to - from) / static_cast<double>(steps);
  const auto moved = [](const CableState<T>& a, const T& factor, const CableState<T>& k) {
    CableState<T> result = a;
    for (std::size_t i = 0; i < a.size(); ++i) result[i] += factor * k[i];
    return result;
  };
  for (int i = 0; i < steps; ++i) {
    const T s = from + static_cast<double>(i) * ds;
    const CableState<T> k1 = cableSlope<T>(cable, h, v, s, y);
    const CableState<T> k2 = cableSlope<T>(cable, h, v, s + 0.5 * ds, moved(y, 0.5 * ds, k1));
    const CableState<T> k3 = cableSlope<T>(cable, h, v, s + 0.5 * ds, moved(y, 0.5 * ds, k2));
    const CableState<T> k4 = cableSlope<T>(cable, h, v, s + ds, moved(y, ds, k3));
    for (std::size_t j = 0; j < y.size(); ++j) y[j] += ds / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
  }
  return y;
}

}  // namespace cdpr_kinetostatics

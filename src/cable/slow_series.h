// The slow solution of the bending cable as a power series: coefficients, derived once by recursion.
//
// With T and theta the magnitude and the direction of the force (h, q t - v), the polar coordinates of the
// force plane, and s = sin(theta), c = cos(theta), sigma = q^2/T^3, z = eps T/(1 + eps T) (units of shot.h):
//
//     beta = alpha - theta = c s sum sigma^k f_k(s^2, z)    m = (q/T) c sum sigma^k g_k(s^2, z)
//
// f_k and g_k are polynomials. sigma is the square of layer thickness over radius of curvature at theta = 0.
#pragma once

#include <array>

namespace cdpr_kinetostatics {

// The first omitted term tells the error, so one order more is known than is ever summed.
constexpr int kSlowOrders = 5;

// A polynomial in y and z: coefficient[i][j] y^i z^j.
struct SlowPolynomial {
  static constexpr int kY = kSlowOrders + 1;
  static constexpr int kZ = 4 * kSlowOrders + 2;
  std::array<std::array<double, kZ>, kY> coefficient{};
  int y_degree = -1;
  int z_degree = -1;
};

struct SlowSeries {
  std::array<SlowPolynomial, kSlowOrders + 1> angle;   // f_k; f_0 = 0
  std::array<SlowPolynomial, kSlowOrders + 1> moment;  // g_k
  // Largest |c s f_k| and |c g_k|/10 over all theta, for z = 0; and the largest times cos^(3 k), which is the
  // share of sigma^k that is left at theta where the cable's lowest point has theta = 0.
  std::array<double, kSlowOrders + 1> largest{};
  std::array<double, kSlowOrders + 1> largest_hanging{};
};

const SlowSeries& slowSeries();

}  // namespace cdpr_kinetostatics

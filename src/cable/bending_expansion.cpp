#include "cable/bending_expansion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cable/tautness.h"

namespace cdpr_kinetostatics {
namespace {

// Gauss-Legendre abscissae and weights on [-1, 1], twelve points, the positive half.
constexpr std::array<double, 6> kAbscissae = {0.1252334085114689, 0.3678314989981802, 0.5873179542866175,
                                              0.7699026741943047, 0.9041172563704749, 0.9815606342467192};
constexpr std::array<double, 6> kWeights = {0.2491470458134028, 0.2334925365383548, 0.2031674267230659,
                                            0.1600783285433462, 0.1069393259953184, 0.0471753363865118};

// The integrand of (24) is analytic in s but at distance |(mid, H)| of the middle; beyond this many half-ranges
// of the vertical force it is integrated over s, else over the slope angle, in which it is entire.
constexpr double kFarPole = 2.5;

// The expansion holds from this kappa L on, and while its second term in the middle is below this share of the first.
constexpr double kLeastLayers = 4.0;
constexpr double kLargestMiddle = 0.05;

// q^2 cos(alpha) (cos(2 alpha), sin(2 alpha))/(e T^3) under the force (H, u), and d/d(H, u).
struct Integrand {
  Integrand(const CableProperties& cable, double h, double u) {
    const double t2 = h * h + u * u;
    const double t = std::sqrt(t2);
    const double e = 1.0 + t / cable.axial_stiffness;
    const double scale = cable.weight * cable.weight / (t2 * t2 * t2 * e);
    value << h * (h * h - u * u), 2.0 * h * h * u;
    value *= scale;
    const double decay = 6.0 / t2 + 1.0 / (t * cable.axial_stiffness * e);
    by_force << 3.0 * h * h - u * u, -2.0 * h * u, 4.0 * h * u, 2.0 * h * h;
    by_force *= scale;
    by_force -= decay * value * Eigen::RowVector2d(h, u);
  }
  Eigen::Vector2d value;
  Eigen::Matrix2d by_force;
};

// (EI^3/2) q^2 H^2/(2 T^(9/2) e^2), the energy that an end's layer saves, and its derivative by (H, u): the
// displacement of the end under that force.
Eigen::Vector2d layerEffect(const CableProperties& cable, double h, double u) {
  const double t2 = h * h + u * u;
  const double t = std::sqrt(t2);
  const double e = 1.0 + t / cable.axial_stiffness;
  const double energy = 0.5 * cable.bending_stiffness * std::sqrt(cable.bending_stiffness) * cable.weight *
                        cable.weight / (t2 * t2 * std::sqrt(t) * e * e);
  const double decay = 4.5 / t2 + 2.0 / (t * cable.axial_stiffness * e);
  return {energy * h * (2.0 - decay * h * h), -energy * decay * h * h * u};
}

// What the middle's own deflection beta = EI kappa_c'/T adds: by (H, u), the derivative of the energy
// T beta^2/2 = 2 EI^2 q^4 H^2 u^2/T^9 that it saves.
Eigen::Vector2d middleEffect(const CableProperties& cable, double h, double u) {
  const double t2 = h * h + u * u;
  const double slenderness = cable.bending_stiffness * cable.weight * cable.weight / (t2 * std::sqrt(t2));  // sigma
  const double scale = 2.0 * slenderness * slenderness * h * u / (t2 * std::sqrt(t2));
  return scale * Eigen::Vector2d(u * (2.0 - 9.0 * h * h / t2), h * (2.0 - 9.0 * u * u / t2));
}

// Calls add(u, ds) at the nodes of a quadrature over the cable; u = q s - V.
template <typename Add>
void overCable(const CableProperties& cable, double h, double v, double length, const Add& add) {
  const double half = 0.5 * cable.weight * length;
  const double middle = half - v;
  if (h * h + middle * middle > kFarPole * kFarPole * half * half) {
    for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
      add(middle + kAbscissae[k] * half, 0.5 * length * kWeights[k]);
      add(middle - kAbscissae[k] * half, 0.5 * length * kWeights[k]);
    }
    return;
  }
  const double angle_a = std::atan2(-v, h);
  const double half_range = 0.5 * (std::atan2(cable.weight * length - v, h) - angle_a);
  const auto at = [&](double abscissa, double weight) {
    const double angle = angle_a + half_range * (1.0 + abscissa);
    const double cosine = std::cos(angle);
    add(h * std::sin(angle) / cosine, half_range * weight * h / (cable.weight * cosine * cosine));
  };
  for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
    at(kAbscissae[k], kWeights[k]);
    at(-kAbscissae[k], kWeights[k]);
  }
}

}  // namespace

EndPoint firstOrderBending(const CableProperties& cable, double h, double v, double length) {
  EndPoint effect;
  if (cable.weight == 0.0 || cable.bending_stiffness == 0.0) return effect;
  overCable(cable, h, v, length, [&](double u, double ds) {
    const Integrand integrand(cable, h, u);
    effect.position += ds * integrand.value;
    effect.jacobian.leftCols<2>() += ds * integrand.by_force;
  });
  effect.jacobian.col(1) *= -1.0;  // u = q s - V
  effect.jacobian.col(2) = Integrand(cable, h, cable.weight * length - v).value;
  effect.position *= cable.bending_stiffness;
  effect.jacobian *= cable.bending_stiffness;
  return effect;
}

BendingExpansion bendingExpansion(const CableProperties& cable, double h, double v, double length) {
  BendingExpansion effect;
  if (cable.weight == 0.0 || cable.bending_stiffness == 0.0) {
    effect.trusted = true;
    return effect;
  }
  if (!pullsAllAlong(cable, length, {h, v})) return effect;
  if (!(h > 0.0)) {  // hangs straight down
    effect.trusted = true;
    return effect;
  }
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  overCable(cable, h, v, length, [&](double u, double ds) {
    first += ds * Integrand(cable, h, u).value;
    middle += ds * middleEffect(cable, h, u);
  });
  first *= cable.bending_stiffness;
  const double u_b = cable.weight * length - v;
  const Eigen::Vector2d layers = layerEffect(cable, h, -v) + layerEffect(cable, h, u_b);
  const double t_a = std::hypot(h, v);
  const double t_b = std::hypot(h, u_b);
  const double half_layers =
      0.25 * length * (std::sqrt(t_a / cable.bending_stiffness) + std::sqrt(t_b / cable.bending_stiffness));
  const double overlap = std::exp(-2.0 * half_layers);
  effect.beyond_first = middle + std::tanh(half_layers) * layers + overlap / std::pow(1.0 + overlap, 2) * first;
  effect.end = first + effect.beyond_first;
  effect.trusted = length * std::sqrt(std::min(t_a, t_b) / cable.bending_stiffness) > kLeastLayers &&
                   middle.norm() < kLargestMiddle * first.norm();
  return effect;
}

}  // namespace cdpr_kinetostatics

#include "support/bare_integration.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {
namespace {

struct State {
  double alpha, moment, x, y;
};

State operator+(const State& a, const State& b) {
  return {a.alpha + b.alpha, a.moment + b.moment, a.x + b.x, a.y + b.y};
}
State operator*(double f, const State& a) { return {f * a.alpha, f * a.moment, f * a.x, f * a.y}; }

// Lengths in units of the thickness of the bending layer, forces in units of the larger end tension.
struct Scaled {
  double force, length;
  double h, v, q, eps;

  explicit Scaled(const KnownCable& c) {
    const double t_a = std::hypot(c.horizontal_force, c.vertical_force_a);
    const double t_b = std::hypot(c.horizontal_force, c.vertical_force_a - c.properties.weight * c.length);
    force = std::max(t_a, t_b);
    length = std::sqrt(c.properties.bending_stiffness / force);
    h = c.horizontal_force / force;
    v = c.vertical_force_a / force;
    q = c.properties.weight * length / force;
    eps = force / c.properties.axial_stiffness;
  }

  State slope(double t, const State& y) const {
    const double cosine = std::cos(y.alpha);
    const double sine = std::sin(y.alpha);
    const double vertical = v - q * t;
    const double e = 1.0 + eps * (h * cosine - vertical * sine);
    return {e * y.moment, e * (h * sine + vertical * cosine), e * cosine, e * sine};
  }
};

// Integrates from t0 to t1; h is the step size, carried on from call to call.
State integrate(const Scaled& f, double t0, double t1, State y, double tolerance, double* h, int* steps) {
  double t = t0;
  State k1 = f.slope(t, y);
  while (t < t1) {
    const double left = t1 - t;
    const bool last = *h >= left;
    const double dt = last ? left : *h;
    const State k2 = f.slope(t + dt / 5, y + dt * (1.0 / 5 * k1));
    const State k3 = f.slope(t + dt * 3 / 10, y + dt * (3.0 / 40 * k1 + 9.0 / 40 * k2));
    const State k4 = f.slope(t + dt * 4 / 5, y + dt * (44.0 / 45 * k1 + -56.0 / 15 * k2 + 32.0 / 9 * k3));
    const State k5 = f.slope(t + dt * 8 / 9, y + dt * (19372.0 / 6561 * k1 + -25360.0 / 2187 * k2 +
                                                       64448.0 / 6561 * k3 + -212.0 / 729 * k4));
    const State k6 = f.slope(t + dt, y + dt * (9017.0 / 3168 * k1 + -355.0 / 33 * k2 + 46732.0 / 5247 * k3 +
                                               49.0 / 176 * k4 + -5103.0 / 18656 * k5));
    const State next =
        y + dt * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 + -2187.0 / 6784 * k5 + 11.0 / 84 * k6);
    const State k7 = f.slope(t + dt, next);
    const auto error_of = [&](double State::*of) {
      return dt * std::abs(71.0 / 57600 * k1.*of - 71.0 / 16695 * k3.*of + 71.0 / 1920 * k4.*of -
                           17253.0 / 339200 * k5.*of + 22.0 / 525 * k6.*of - 1.0 / 40 * k7.*of);
    };
    const double error = std::max(error_of(&State::alpha), error_of(&State::moment)) / tolerance;
    const double factor = std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 5.0);
    ++*steps;
    if (error <= 1.0) {
      t = last ? t1 : t + dt;
      y = next;
      k1 = k7;
    }
    if (error > 1.0 || !last) *h = dt * factor;
  }
  return y;
}

}  // namespace

double layersOf(const KnownCable& cable) { return cable.length / Scaled(cable).length; }

int nodesFor(const KnownCable& cable, double layers_between) {
  return std::max(2, static_cast<int>(std::ceil(layersOf(cable) / layers_between)) + 1);
}

BarePass integrateBare(const KnownCable& cable, double tolerance) {
  const Scaled f(cable);
  const double moment_unit = f.force * f.length;
  BarePass pass;
  double step = 0.5;
  double x = 0.0;
  double y = 0.0;
  for (std::size_t k = 0; k + 1 < cable.nodes.size(); ++k) {
    const ProfilePoint& from = cable.nodes[k];
    const ProfilePoint& to = cable.nodes[k + 1];
    const State end = integrate(f, from.s / f.length, to.s / f.length,
                                {from.alpha, from.moment / moment_unit, 0.0, 0.0}, tolerance, &step, &pass.steps);
    x += end.x;
    y += end.y;
    pass.departure = std::max(pass.departure, std::abs(end.alpha - to.alpha));
  }
  pass.x = x * f.length;
  pass.y = y * f.length;
  return pass;
}

}  // namespace cdpr_kinetostatics

#include "cable/catenary.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cable/cable_checks.h"

namespace cdpr_kinetostatics {
namespace {

// Bounds the time: from the starts below Newton's method takes a few on this convex energy.
constexpr int kMaxNewtonIterations = 100;

// A step of the forces [share of the tension] below the first is rounding; one below the second that no longer shrinks
// is, too. Below the third there is no line search: slopes would be rounding.
constexpr double kRoundingStep = 1e-15;
constexpr double kSmallStep = 1e-7;
constexpr double kNoSearch = 1e-9;

// The horizontal force keeps this share of itself in a step; a step has gone too far where the energy rises with more
// than this share of the slope with which it fell; it is never shortened below the last.
constexpr double kLeastShare = 0.1;
constexpr double kOvershoot = 0.9;
constexpr double kShortestStep = 1e-6;

// The quantities that every formula shares: vertical force u at A and v at B, tensions at both.
struct Ends {
  Ends(const CableProperties& cable, double h, double v_a, double length)
      : u(v_a), v(v_a - cable.weight * length), t_a(std::hypot(h, u)), t_b(std::hypot(h, v)) {}
  double u, v, t_a, t_b;
};

// Integral of ds/T. With r = q L/(T_A + T_B) it is (2/q) atanh(r); r -> 1 where the cable hangs as a
// narrow loop, and there the logarithm is written with 1 - r in closed form.
double inverseTensionIntegral(const CableProperties& cable, double h, const Ends& e, double length) {
  const double sum = e.t_a + e.t_b;
  const double r = cable.weight * length / sum;
  if (r < 1e-4) return 2.0 * length / sum * (1.0 + r * r / 3.0);
  if (r < 0.5) return 2.0 / cable.weight * std::atanh(r);
  if (e.u < 0.0 && e.v < 0.0) return std::log((e.t_b - e.v) / (e.t_a - e.u)) / cable.weight;
  const double above_a = e.u > 0.0 ? e.t_a + e.u : h * h / (e.t_a - e.u);
  const double above_b = e.v > 0.0 ? e.t_b + e.v : h * h / (e.t_b - e.v);
  return std::log(above_a / above_b) / cable.weight;
}

// Integral of H^2/T^3 ds = [u/T]/q.
double curvatureIntegral(const CableProperties& cable, double h, const Ends& e, double length) {
  if (e.u * e.v < 0.0 && h * h < -e.u * e.v) return (e.u / e.t_a - e.v / e.t_b) / cable.weight;
  return length * (e.t_a + e.t_b) * h * h / (e.t_a * e.t_b * (h * h + e.t_a * e.t_b + e.u * e.v));
}

// Tension of a taut cable: stretch plus the parabola's sag make up for the excess of the chord.
double tautTension(const CableProperties& cable, double length, double x, double chord) {
  const double excess = chord / length - 1.0;
  const double weight = cable.weight * x;
  const double sag = chord / length * weight * weight / 24.0;
  double t = std::max(excess * cable.axial_stiffness, std::sqrt(sag / std::max(std::abs(excess), 1e-12)));
  if (!std::isfinite(t)) t = std::sqrt(sag / std::abs(excess));
  // The root without excess, EA times the cube root of a ratio: a cube root of newtons would round otherwise in
  // kilonewtons.
  const double ea = cable.axial_stiffness;
  t = std::max({t, std::isfinite(ea) ? ea * std::cbrt(sag / (ea * ea)) : 0.0, 1e-300});
  for (int i = 0; i < 60; ++i) {  // increasing and concave in T from the right of the root: monotone after one step
    const double f = t / cable.axial_stiffness - sag / (t * t) - excess;
    const double df = 1.0 / cable.axial_stiffness + 2.0 * sag / (t * t * t);
    const double next = std::max(0.1 * t, t - f / df);
    if (std::abs(next - t) < 1e-6 * t) return next;
    t = next;
  }
  return t;
}

// Inextensible catenary: sinh(xi)/xi = sqrt(L^2 - y^2)/x, xi = q x/(2 H).
ForcesAtA inextensibleForces(double weight, double length, double x, double y) {
  const double ratio = std::sqrt((length - y) * (length + y)) / x;
  double xi = ratio < 3.0 ? std::sqrt(6.0 * (ratio - 1.0)) : std::log(2.0 * ratio) + std::log(std::log(2.0 * ratio));
  for (int i = 0; i < 60; ++i) {  // on log(sinh(xi)/xi), convex
    const double log_sinhc = xi < 1e-3 ? xi * xi / 6.0 : xi + std::log(-std::expm1(-2.0 * xi) / (2.0 * xi));
    const double slope = xi < 1e-3 ? xi / 3.0 : 1.0 / std::tanh(xi) - 1.0 / xi;
    const double step = (log_sinhc - std::log(ratio)) / slope;
    xi = std::max(0.1 * xi, xi - step);
    if (std::abs(step) < 1e-10 * xi) break;
  }
  return {weight * x / (2.0 * xi), 0.5 * weight * (length - y / std::tanh(xi))};
}

// x = 0: the cable hangs along the vertical, y(V) is piecewise linear and decreasing.
ForcesAtA verticalForces(const CableProperties& cable, double length, double y) {
  const double half = 0.5 * cable.weight * length;
  const double compliance = length / cable.axial_stiffness;
  if (cable.weight > 0.0) {
    const double slack = (half * compliance + length - y) / (compliance + 2.0 / cable.weight);
    if (slack >= 0.0 && slack <= 2.0 * half) return {0.0, slack};
  }
  const double taut = std::abs(y) - length;
  return {0.0, half - std::copysign(taut / compliance, y)};
}

ForcesAtA initialForces(const CableProperties& cable, double length, double x, double y) {
  const double chord = std::hypot(x, y);
  const double t = tautTension(cable, length, x, chord);
  if (length > chord && cable.weight * x > 1.5 * t) return inextensibleForces(cable.weight, length, x, y);
  return {t * x / chord, -t * y / chord + 0.5 * cable.weight * length};
}

// Line search of the Newton step of (H, V), on the slope of the energy along it. Moves the forces; the end under them.
EndPoint searchAlong(const CableProperties& cable, double length, const Eigen::Vector2d& goal,
                     const Eigen::Vector2d& defect, const Eigen::Vector2d& step, double tension, ForcesAtA* forces) {
  const Eigen::Vector2d along(step.x(), -step.y());
  const double slope = defect.dot(along);
  double t = 1.0;
  if (forces->horizontal + step.x() < kLeastShare * forces->horizontal) {
    t = (kLeastShare - 1.0) * forces->horizontal / step.x();
  }
  for (;; t *= 0.5) {
    const ForcesAtA trial{forces->horizontal + t * step.x(), forces->vertical + t * step.y()};
    const EndPoint end = catenaryEnd(cable, trial.horizontal, trial.vertical, length);
    const bool overshoot = -(goal - end.position).dot(along) > kOvershoot * slope;
    if (!overshoot || t < kShortestStep || step.norm() < kNoSearch * tension) {
      *forces = trial;
      return end;
    }
  }
}

}  // namespace

EndPoint catenaryEnd(const CableProperties& cable, double h, double v_a, double length) {
  const Ends e(cable, h, v_a, length);
  const double sum = e.t_a + e.t_b;
  const double inverse_tension = inverseTensionIntegral(cable, h, e, length);
  const double curvature = curvatureIntegral(cable, h, e, length);
  const double axial = length / cable.axial_stiffness;
  const double coupling = h * length * (e.u + e.v) / (e.t_a * e.t_b * sum);
  const double stretch_b = 1.0 / cable.axial_stiffness + 1.0 / e.t_b;

  EndPoint end;
  end.position << (h == 0.0 ? 0.0 : h * (axial + inverse_tension)), -0.5 * (e.u + e.v) * (axial + 2.0 * length / sum);
  end.jacobian << axial + inverse_tension - curvature, -coupling, h * stretch_b,  //
      coupling, -axial - curvature, -e.v * stretch_b;
  return end;
}

double catenaryHorizontalCompliance(const CableProperties& cable, double h, double v_a, double length) {
  return length / cable.axial_stiffness + inverseTensionIntegral(cable, h, Ends(cable, h, v_a, length), length);
}

double catenaryAngle(const CableProperties& cable, double h, double v_a, double s) {
  return std::atan2(cable.weight * s - v_a, h);
}

double catenaryStrainedLength(const CableProperties& cable, double h, double v_a, double length) {
  const Ends e(cable, h, v_a, length);
  const double sum = e.t_a + e.t_b;
  if (sum == 0.0) return length;
  const double loop = h == 0.0 ? 0.0 : h * h * inverseTensionIntegral(cable, h, e, length);
  const double mean = 0.5 * length * (sum + (e.u + e.v) * (e.u + e.v) / sum);
  return length + 0.5 * (mean + loop) / cable.axial_stiffness;
}

Status catenaryReach(const CableProperties& cable, double length, double chord) {
  if (std::isinf(cable.axial_stiffness) && length <= chord) return cannotReach(length, chord);
  if (cable.weight == 0.0 && length >= chord) {
    return {Code::kInfeasible,
            "a slack cable without weight and bending stiffness has no defined shape: give it a linear density"};
  }
  return {Code::kConverged, ""};
}

SolveOutcome solveCatenaryForces(const CableProperties& cable, double length, double x, double y, ForcesAtA* forces) {
  const double chord = std::hypot(x, y);
  const Status reach = catenaryReach(cable, length, chord);
  if (!reach.ok()) return {reach};
  if (x == 0.0) {
    *forces = verticalForces(cable, length, y);
    return {{Code::kConverged, ""}};
  }

  // f = (H, -V); the end point (x, y) is the gradient of the complementary energy with respect to f.
  SolveOutcome outcome{{Code::kNotConverged, "the catenary's forces were not found"}};
  *forces = initialForces(cable, length, x, y);
  EndPoint end = catenaryEnd(cable, forces->horizontal, forces->vertical, length);
  double last_step = std::numeric_limits<double>::infinity();
  while (outcome.iterations < kMaxNewtonIterations) {
    ++outcome.iterations;
    const Eigen::Vector2d defect(x - end.position.x(), y - end.position.y());
    outcome.closure_residual = defect.norm();
    const Eigen::Matrix2d compliance = end.jacobian.leftCols<2>();
    const Eigen::Vector2d step = compliance.inverse() * defect;  // of (H, V)
    if (!step.allFinite()) break;
    const double tension = forces->tension() + cable.weight * length;
    const double size = step.norm();
    end = searchAlong(cable, length, {x, y}, defect, step, tension, forces);
    if (size <= kRoundingStep * tension || (size < kSmallStep * tension && size >= 0.5 * last_step)) {
      outcome.status = {Code::kConverged, ""};
      break;
    }
    last_step = size;
  }
  return outcome;
}

std::optional<ForcesAtA> catenaryForces(const CableProperties& cable, double length, double x, double y) {
  ForcesAtA forces;
  return solveCatenaryForces(cable, length, x, y, &forces).ok() ? std::optional(forces) : std::nullopt;
}

}  // namespace cdpr_kinetostatics

#include "cable/slow_manifold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cable/bounded_count.h"
#include "cable/catenary.h"
#include "cable/slow_series.h"

namespace cdpr_kinetostatics {
namespace {

// Gauss quadrature over panels of at most this turn, with so many nodes: the integrand is close to a trigonometric
// polynomial of the turn, of which nothing is left above rounding.
struct Quadrature {
  double largest_turn;  // [rad]
  int nodes;
  std::array<double, 8> node, weight;  // on [-1, 1]
};
constexpr Quadrature kSmallTurn = {0.1,
                                   4,
                                   {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526},
                                   {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538}};
constexpr Quadrature kAnyTurn = {0.8,
                                 8,
                                 {-0.9602898564975363, -0.7966664774136267, -0.5255324099163290, -0.1834346424956498,
                                  0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363},
                                 {0.1012285362903763, 0.2223810344533745, 0.3137066458778873, 0.3626837833783620,
                                  0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763}};

// More than a whole turn takes.
constexpr int kMostPanels = 16;

// The force at t in polar coordinates.
struct Force {
  Force(const ShotParameters& p, double t)
      : u(p.q * t - p.v), tension(std::hypot(p.h, u)), c(p.h / tension), s(u / tension) {}
  double u, tension, c, s;
};

// A quantity with its derivatives along and across the force: T d/dT and d/dtheta.
struct Polar {
  double value = 0.0;
  double radial = 0.0;
  double angular = 0.0;
};

struct Sum {
  double value = 0.0;
  double dy = 0.0;
  double dz = 0.0;
};

Sum evaluate(const SlowPolynomial& p, double y, double z, int z_degree) {
  Sum sum;
  const int degree = std::min(p.z_degree, z_degree);
  for (int i = p.y_degree; i >= 0; --i) {
    double value = 0.0;
    double dz = 0.0;
    for (int j = degree; j >= 0; --j) {
      dz = dz * z + value;
      value = value * z + p.coefficient[i][j];
    }
    sum.dy = sum.dy * y + sum.value;
    sum.value = sum.value * y + value;
    sum.dz = sum.dz * y + dz;
  }
  return sum;
}

// Powers of z from this one on are below rounding; none is where the stretch is all there is.
int degreeInStretch(double z) {
  constexpr double kRoundingLog = 40.0;  // exp(-40) is 4e-18
  constexpr int kEveryPower = SlowPolynomial::kZ;
  if (!(z > 0.0)) return 0;
  return z < 1.0 ? boundedCount(kRoundingLog / -std::log(z), 0, kEveryPower) : kEveryPower;
}

// The sum over the orders from first on, as a function of T and theta.
Polar sumSeries(const std::array<SlowPolynomial, kSlowOrders + 1>& terms, int first, int order, double sigma,
                const Force& f, double z) {
  const double y = f.s * f.s;
  const int z_degree = degreeInStretch(z);
  Polar result;
  double power = first == 0 ? 1.0 : sigma;
  for (int k = first; k <= order; ++k) {
    const Sum sum = evaluate(terms[k], y, z, z_degree);
    result.value += power * sum.value;
    result.radial += power * (-3.0 * k * sum.value + z * (1.0 - z) * sum.dz);
    result.angular += power * 2.0 * f.s * f.c * sum.dy;
    power *= sigma;
  }
  return result;
}

// Integral of dt/T.
double inverseTension(const ShotParameters& p, double t0, double t1) {
  return catenaryHorizontalCompliance({std::numeric_limits<double>::infinity(), 0.0, p.q}, p.h, p.v - p.q * t0,
                                      t1 - t0);
}

double strainShare(double tau) { return tau / (1.0 + tau); }

Polar slowAngle(const ShotParameters& p, const Force& f, int order) {
  const double sigma = p.q * p.q / (f.tension * f.tension * f.tension);
  const Polar sum = sumSeries(slowSeries().angle, 1, order, sigma, f, strainShare(p.eps * f.tension));
  const double cs = f.c * f.s;
  return {cs * sum.value, cs * sum.radial, (f.c * f.c - f.s * f.s) * sum.value + cs * sum.angular};
}

Polar slowMoment(const ShotParameters& p, const Force& f, int order) {
  const double sigma = p.q * p.q / (f.tension * f.tension * f.tension);
  const Polar sum = sumSeries(slowSeries().moment, 0, order, sigma, f, strainShare(p.eps * f.tension));
  const double r = p.q / f.tension;
  return {r * f.c * sum.value, r * f.c * (sum.radial - sum.value), r * (f.c * sum.angular - f.s * sum.value)};
}

// Derivatives with respect to h and to q t - v.
double alongH(const Polar& a, const Force& f) { return (f.c * a.radial - f.s * a.angular) / f.tension; }
double alongU(const Polar& a, const Force& f) { return (f.s * a.radial + f.c * a.angular) / f.tension; }

// (x', y') less those of the catenary.
std::array<Polar, 2> excess(const ShotParameters& p, const Force& f, int order) {
  const Polar beta = slowAngle(p, f, order);
  const double tau = p.eps * f.tension;
  const double sine = std::sin(beta.value);
  const double cosine = std::cos(beta.value);
  const double half = std::sin(0.5 * beta.value);
  // Along the force and across it, and differentiated with respect to beta.
  const double along = -2.0 * half * half - tau * sine * sine;
  const double across = (1.0 + tau * cosine) * sine;
  const double along_beta = -sine * (1.0 + 2.0 * tau * cosine);
  const double across_beta = cosine + tau * (cosine * cosine - sine * sine);
  const double along_radial = along_beta * beta.radial - tau * sine * sine;
  const double across_radial = across_beta * beta.radial + tau * cosine * sine;
  const double along_angular = along_beta * beta.angular - across;
  const double across_angular = across_beta * beta.angular + along;
  return {Polar{along * f.c - across * f.s, along_radial * f.c - across_radial * f.s,
                along_angular * f.c - across_angular * f.s},
          Polar{along * f.s + across * f.c, along_radial * f.s + across_radial * f.c,
                along_angular * f.s + across_angular * f.c}};
}

// t as a function of the turn of the force from t0 on. turn/(q h) and, with it, t stay finite where h or q
// vanishes: t - t0 = T0 T sin(turn)/(q h).
class Turn {
 public:
  Turn(const ShotParameters& p, double t0, double t1) : q_(p.q), t0_(t0), from_(p, t0) {
    const Force to(p, t1);
    const double cosine = p.h * p.h + from_.u * to.u;
    const double sine = p.h * p.q * (t1 - t0);
    angle_ = std::atan2(sine, cosine);
    reach_ = (t1 - t0) * (std::abs(sine) > 1e-9 * std::abs(cosine) ? angle_ / sine : 1.0 / cosine);
  }
  double angle() const { return angle_; }

  struct At {
    double t = 0.0;
    double rate = 0.0;  // dt/dshare
  };
  At at(double share) const {
    const double turn = share * angle_;
    const double slope = share * reach_ * (std::abs(turn) > 1e-8 ? std::sin(turn) / turn : 1.0);
    const double tension = from_.tension / (std::cos(turn) - from_.u * q_ * slope);
    return {t0_ + from_.tension * tension * slope, tension * tension * reach_};
  }

 private:
  double q_, t0_;
  Force from_;
  double angle_ = 0.0;
  double reach_ = 0.0;  // angle/(q h)
};

}  // namespace

bool hasQuietForce(const ShotParameters& p, double t0, double t1) {
  const double u0 = p.q * t0 - p.v;
  const double u1 = p.q * t1 - p.v;
  return p.h > 0.0 || (u0 * u1 > 0.0 && p.h * p.h + u0 * u1 > 0.0);
}

int slowOrder(const ShotParameters& p, double t0, double t1, double error) {
  if (!hasQuietForce(p, t0, t1)) return 0;
  const Force from(p, t0);
  const Force to(p, t1);
  const bool hanging = from.u < 0.0 && to.u > 0.0;
  const double tension = hanging ? p.h : std::min(from.tension, to.tension);
  const double sigma = p.q * p.q / (tension * tension * tension);
  const std::array<double, kSlowOrders + 1>& largest = hanging ? slowSeries().largest_hanging : slowSeries().largest;
  double power = sigma;
  for (int k = 1; k < kSlowOrders; ++k) {
    power *= sigma;
    if (largest[k + 1] * sigma > 0.5 * largest[k]) return 0;
    if (largest[k + 1] * power <= error) return k;
  }
  return 0;
}

SlowState slowState(const ShotParameters& p, double t, int order) {
  const Force f(p, t);
  const Polar beta = slowAngle(p, f, order);
  const Polar moment = slowMoment(p, f, order);
  const double alpha_h = -f.s / f.tension + alongH(beta, f);
  const double alpha_u = f.c / f.tension + alongU(beta, f);
  const double moment_u = alongU(moment, f);
  SlowState state;
  state.alpha = std::atan2(f.u, p.h) + beta.value;
  state.moment = moment.value;
  state.tension = f.tension;
  state.tension_derivative << f.c, -f.s, p.q * f.s;
  state.turn_derivative << -f.s / f.tension, -f.c / f.tension, p.q * f.c / f.tension;
  state.derivative << alpha_h, -alpha_u, p.q * alpha_u, alongH(moment, f), -moment_u, p.q * moment_u;

  // dm = rho da with rho^2 = T cos(beta) - rho'/e, in two terms. The modes shift the cable across the force by
  // the change of the moment over the force (m' = h y' + v(t) x'), on average where they have fallen to 1/e.
  const double rate = std::sqrt(f.tension * std::cos(beta.value));
  const double rise = p.q * f.s / (1.0 + p.eps * f.tension);  // dT/dp
  const double bend = 0.25 * rise / f.tension;
  state.decay = rate + bend;
  state.growth = rate - bend;
  const double alpha_ahead = state.alpha + state.moment / rate;
  const double alpha_behind = state.alpha - state.moment / rate;
  state.ahead =
      state.decay / (f.tension + rise / rate) * Eigen::Vector2d(-std::sin(alpha_ahead), std::cos(alpha_ahead));
  state.behind =
      state.growth / (f.tension - rise / rate) * Eigen::Vector2d(-std::sin(alpha_behind), std::cos(alpha_behind));
  return state;
}

SlowStretch slowStretch(const ShotParameters& p, double t0, double t1, int order) {
  const CableProperties cable{1.0 / p.eps, 0.0, p.q};
  const EndPoint catenary = catenaryEnd(cable, p.h, p.v - p.q * t0, t1 - t0);
  const Force from(p, t0);
  const double e = 1.0 + p.eps * from.tension;
  SlowStretch stretch;
  stretch.displacement = catenary.position;
  stretch.derivative << catenary.jacobian.leftCols<2>(), -e * Eigen::Vector2d(from.c, from.s), catenary.jacobian.col(2);
  if (p.q == 0.0) return stretch;

  const Turn turn(p, t0, t1);
  const double angle = std::abs(turn.angle());
  const Quadrature& rule = angle <= kSmallTurn.largest_turn ? kSmallTurn : kAnyTurn;
  const int panels = boundedCount(angle / rule.largest_turn, 1, kMostPanels);
  for (int i = 0; i < rule.nodes * panels; ++i) {
    const int node = i % rule.nodes;
    const int panel = i / rule.nodes;
    const Turn::At at = turn.at((panel + 0.5 * (1.0 + rule.node[node])) / panels);
    const double weight = 0.5 * rule.weight[node] / panels * at.rate;
    const Force f(p, at.t);
    const std::array<Polar, 2> slope = excess(p, f, order);
    for (int row = 0; row < 2; ++row) {
      stretch.displacement[row] += weight * slope[row].value;
      stretch.derivative(row, 0) += weight * alongH(slope[row], f);
      stretch.derivative(row, 1) -= weight * alongU(slope[row], f);
    }
  }
  const std::array<Polar, 2> begin = excess(p, from, order);
  const std::array<Polar, 2> end = excess(p, Force(p, t1), order);
  for (int row = 0; row < 2; ++row) {
    stretch.derivative(row, 2) -= begin[row].value;
    stretch.derivative(row, 3) += end[row].value;
  }
  return stretch;
}

// q dt/T = d asinh(u/h): t - t0 = 2/q sinh(rise/2) (T0 cosh(rise/2) + u0 sinh(rise/2)).
double atShareOfRise(const ShotParameters& p, double t0, double t1, double share) {
  if (share >= 1.0) return t1;
  const double integral = share * inverseTension(p, t0, t1);
  const double half = 0.5 * p.q * integral;
  const Force from(p, t0);
  const double sine = std::sinh(half);
  const double sum = from.u < 0.0 ? from.tension * std::exp(-half) + p.h * p.h / (from.tension - from.u) * sine
                                  : from.tension * std::cosh(half) + from.u * sine;
  return t0 + integral * (half > 1e-8 ? sine / half : 1.0) * sum;
}

double riseOfForce(const ShotParameters& p, double t0, double t1) { return p.q * inverseTension(p, t0, t1); }

}  // namespace cdpr_kinetostatics

// The coefficients of the slow solution against those found by hand, and against the cable's equations.
#include "cable/slow_series.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cable/shot.h"

namespace cdpr_kinetostatics {
namespace {

double valueAt(const SlowPolynomial& p, double y, double z) {
  double sum = 0.0;
  for (int i = 0; i <= p.y_degree; ++i) {
    for (int j = 0; j <= p.z_degree; ++j) sum += p.coefficient[i][j] * std::pow(y, i) * std::pow(z, j);
  }
  return sum;
}

// The inextensible cable to first order. With theta' = q c/T, T' = q s: m = alpha' = q c/T, and S = m' = -T sin(beta)
// = -2 q^2 c s/T^2 gives beta = 2 c s q^2/T^3, so that g_0 = 1 and f_1 = +-2, whatever s.
TEST(SlowSeries, FirstTermsAreThoseFoundByHand) {
  const SlowSeries& series = slowSeries();
  for (const double y : {0.0, 0.3, 1.0}) {
    EXPECT_NEAR(valueAt(series.moment[0], y, 0.0), 1.0, 1e-14);
    EXPECT_NEAR(std::abs(valueAt(series.angle[1], y, 0.0)), 2.0, 1e-14);
    EXPECT_EQ(valueAt(series.angle[0], y, 0.2), 0.0);
  }
}

// alpha' = e m and m' = e S, with derivatives along the cable by differences. The series is asymptotic: with all terms
// the residual is of the order of the first that is left out.
TEST(SlowSeries, SumsToASolutionOfTheCablesEquations) {
  const SlowSeries& series = slowSeries();
  const ShotParameters p{0.5, 0.4, 0.01, 0.02};
  const auto solution = [&](double t) -> ShotState {
    const double v = p.q * t - p.v;
    const double tension = std::hypot(p.h, v);
    const double s = v / tension, c = p.h / tension;
    const double z = p.eps * tension / (1.0 + p.eps * tension);
    const double sigma = p.q * p.q / std::pow(tension, 3);
    double beta = 0.0, moment = 0.0, power = 1.0;
    for (int k = 0; k < kSlowOrders; ++k, power *= sigma) {
      beta += c * s * power * valueAt(series.angle[k], s * s, z);
      moment += p.q / tension * c * power * valueAt(series.moment[k], s * s, z);
    }
    return {std::atan2(v, p.h) + beta, moment, 0.0, 0.0};
  };
  const double d = 0.05;  // sixth order: differences err by (d q/T)^6
  for (const double t : {10.0, 40.0, 70.0}) {
    const auto slope = [&](double ShotState::*component) {
      const auto at = [&](int i) { return solution(t + i * d).*component; };
      return (45.0 * (at(1) - at(-1)) - 9.0 * (at(2) - at(-2)) + (at(3) - at(-3))) / (60.0 * d);
    };
    const ShotState exact = shotDerivative(p, t, solution(t));
    const double tension = std::hypot(p.h, p.q * t - p.v);
    const double left_out = series.largest[kSlowOrders] * std::pow(p.q * p.q / std::pow(tension, 3), kSlowOrders);
    EXPECT_NEAR(slope(&ShotState::alpha), exact.alpha, 1e-13 + 10.0 * tension * left_out);
    EXPECT_NEAR(slope(&ShotState::moment), exact.moment, 1e-13 + 10.0 * tension * left_out);
    EXPECT_LT(10.0 * tension * left_out, 1e-7) << "an error in a term that is summed must be seen";
  }
}

// What tells whether a term matters bounds the term itself.
TEST(SlowSeries, BoundsAreThoseOfTheTerms) {
  const SlowSeries& series = slowSeries();
  for (int k = 1; k <= kSlowOrders; ++k) {
    double largest = 0.0;
    for (double theta = -1.57; theta <= 1.57; theta += 0.01) {
      const double s = std::sin(theta), c = std::cos(theta);
      largest = std::max({largest, std::abs(c * s * valueAt(series.angle[k], s * s, 0.0)),
                          0.1 * std::abs(c * valueAt(series.moment[k], s * s, 0.0))});
    }
    EXPECT_GE(series.largest[k], 0.999 * largest) << k;
    EXPECT_LE(series.largest[k], 1.01 * largest) << k;
    EXPECT_LE(series.largest_hanging[k], series.largest[k]) << k;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

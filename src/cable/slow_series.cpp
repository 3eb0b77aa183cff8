#include "cable/slow_series.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {
namespace {

// Powers of s and of z, and of sigma. Every quantity of the recursion is such a sum, or c times one.
constexpr int kS = 2 * kSlowOrders + 2;
constexpr int kZ = SlowPolynomial::kZ;
struct Polynomial {
  std::array<std::array<double, kZ>, kS> coefficient{};
};
struct Series {
  std::array<Polynomial, kSlowOrders + 1> order;
};

template <typename Function>
void forEachTerm(const Series& a, const Function& function) {
  for (int k = 0; k <= kSlowOrders; ++k) {
    for (int i = 0; i < std::min(kS, 2 * k + 3); ++i) {  // no higher powers occur
      for (int j = 0; j < std::min(kZ, 4 * k + 4); ++j) {
        if (a.order[k].coefficient[i][j] != 0.0) function(k, i, j, a.order[k].coefficient[i][j]);
      }
    }
  }
}

void add(int k, int i, int j, double value, Series* sum) {
  if (k <= kSlowOrders && i < kS && j < kZ) sum->order[k].coefficient[i][j] += value;
}

Series term(int k, int i, int j, double value) {
  Series result;
  add(k, i, j, value, &result);
  return result;
}

Series operator+(Series a, const Series& b) {
  forEachTerm(b, [&](int k, int i, int j, double value) { add(k, i, j, value, &a); });
  return a;
}

Series operator*(const Series& a, const Series& b) {
  Series product;
  forEachTerm(a, [&](int k, int i, int j, double x) {
    forEachTerm(b, [&](int l, int m, int n, double y) { add(k + l, i + m, j + n, x * y, &product); });
  });
  return product;
}

Series operator*(double factor, const Series& a) { return term(0, 0, 0, factor) * a; }

// (T/q) d/dt of c a, divided by c. Along the cable (T/q) d/dt acts as: theta -> c, sigma -> -3 s sigma,
// z -> s z (1 - z).
Series derivative(const Series& a) {
  Series result;
  forEachTerm(a, [&](int k, int i, int j, double value) {
    if (i > 0) add(k, i - 1, j, i * value, &result);
    add(k, i + 1, j, (j - 3 * k - 1 - i) * value, &result);
    add(k, i + 1, j + 1, -j * value, &result);
  });
  return result;
}

SlowPolynomial inSquares(const Polynomial& p, int first) {
  SlowPolynomial result;
  for (int i = first; i < kS; i += 2) {
    for (int j = 0; j < kZ; ++j) {
      if (p.coefficient[i][j] == 0.0) continue;
      result.coefficient[(i - first) / 2][j] = p.coefficient[i][j];
      result.y_degree = std::max(result.y_degree, (i - first) / 2);
      result.z_degree = std::max(result.z_degree, j);
    }
  }
  return result;
}

double withoutStretch(const SlowPolynomial& p, double y) {
  double sum = 0.0;
  for (int i = p.y_degree; i >= 0; --i) sum = sum * y + p.coefficient[i][0];
  return sum;
}

// beta = c b solves sin(beta) = sigma/e (D - s) [(c + D beta)/e], D = (T/q) d/dt, 1/e = (1 - z)/(1 + z (cos(beta) -
// 1)).
SlowSeries derive() {
  const Series one = term(0, 0, 0, 1.0);
  const Series c_squared = one + term(0, 2, 0, -1.0);
  Series b;
  Series moment;
  for (int k = 0; k <= kSlowOrders; ++k) {
    const Series square = c_squared * (b * b);
    const Series excess = term(0, 0, 1, 1.0) * (-0.5 * square + 1.0 / 24.0 * (square * square));
    const Series inverse_e = (one + term(0, 0, 1, -1.0)) * (one + -1.0 * excess + excess * excess);
    moment = inverse_e * (one + derivative(b));
    if (k == kSlowOrders) break;
    const Series sine = term(1, 0, 0, 1.0) * (inverse_e * (derivative(moment) + term(0, 1, 0, -1.0) * moment));
    const Series sine_squared = c_squared * (sine * sine);
    b = sine * (one + 1.0 / 6.0 * sine_squared + 3.0 / 40.0 * (sine_squared * sine_squared));
  }
  SlowSeries series;
  constexpr int kAngles = 200;
  for (int k = 0; k <= kSlowOrders; ++k) {
    series.angle[k] = inSquares(b.order[k], 1);
    series.moment[k] = inSquares(moment.order[k], 0);
    for (int i = 0; i <= kAngles; ++i) {
      const double theta = 0.5 * M_PI * i / kAngles;
      const double y = std::pow(std::sin(theta), 2);
      const double angle = std::abs(0.5 * std::sin(2.0 * theta) * withoutStretch(series.angle[k], y));
      const double turn = std::abs(std::cos(theta) * withoutStretch(series.moment[k], y));
      series.largest[k] = std::max({series.largest[k], angle, 0.1 * turn});
      const double share = std::pow(std::cos(theta), 3 * k);  // of sigma^k at theta = 0
      series.largest_hanging[k] = std::max({series.largest_hanging[k], share * angle, share * 0.1 * turn});
    }
  }
  return series;
}

}  // namespace

const SlowSeries& slowSeries() {
  static const SlowSeries series = derive();
  return series;
}

}  // namespace cdpr_kinetostatics

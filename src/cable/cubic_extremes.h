// Where a quantity is extreme that is known with its slope at the ends of intervals.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace cdpr_kinetostatics {

// An extreme is located by cubics again so many times, in the part of the interval where it lies, or until the slope
// there, over that part, is below this share of the value.
inline constexpr int kRefinements = 3;
inline constexpr double kFlat = 1e-10;

struct Sample {
  double value = 0.0;
  double slope = 0.0;
};

// Where the cubic that has these values and slopes at the ends of an interval of length h is extreme, as shares
// of the interval; outside (0, 1) where it is monotonic.
inline std::array<double, 2> extremesOfCubic(const Sample& a, const Sample& b, double h) {
  const double c1 = h * a.slope;
  const double c2 = 3.0 * (b.value - a.value) - h * (2.0 * a.slope + b.slope);
  const double c3 = 2.0 * (a.value - b.value) + h * (a.slope + b.slope);
  const double discriminant = c2 * c2 - 3.0 * c1 * c3;
  if (discriminant < 0.0) return {-1.0, -1.0};
  // Roots of c1 + 2 c2 u + 3 c3 u^2, without cancellation.
  const double root = -(c2 + std::copysign(std::sqrt(discriminant), c2));
  return {root / (3.0 * c3), c1 / root};
}

struct Located {
  double t = 0.0;
  Sample sample;
};

// The largest size that a quantity reaches next to a place between a and b where their cubic is extreme; at(t) is the
// quantity itself.
template <typename At>
double largestNear(Located a, double place, Located b, const At& at) {
  double largest = 0.0;
  for (int i = 0; i < kRefinements; ++i) {
    const Located here{place, at(place)};
    largest = std::max(largest, std::abs(here.sample.value));
    const bool beyond = (here.sample.slope > 0.0) == (a.sample.slope > 0.0);
    (beyond ? a : b) = here;
    const double width = b.t - a.t;
    const bool encloses = (a.sample.slope > 0.0) != (b.sample.slope > 0.0);
    if (!encloses || std::abs(here.sample.slope) * width <= kFlat * std::abs(here.sample.value)) break;
    const std::array<double, 2> shares = extremesOfCubic(a.sample, b.sample, width);
    const double share = shares[0] > 0.0 && shares[0] < 1.0 ? shares[0] : shares[1];
    if (!(share > 0.0 && share < 1.0)) break;
    place = a.t + share * width;
  }
  return largest;
}

}  // namespace cdpr_kinetostatics

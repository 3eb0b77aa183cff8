// The solution without layers against the cable's own equations: its terms, its derivatives, its stretches.
#include "cable/slow_manifold.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace cdpr_kinetostatics {
namespace {

// Units of shot.h.
constexpr ShotParameters kBows[] = {{0.8, 0.3, 0.01, 0.0},
                                    {0.8, 0.3, 0.01, 1e-3},
                                    {0.3, -0.7, 0.004, 0.05},
                                    {1e-3, -0.9, 0.01, 1e-4},
                                    {-0.1, -0.9, 0.01, 0.0}};

TEST(SlowManifold, ObeysTheCablesEquationsTheBetterTheMoreTerms) {
  for (const ShotParameters& p : kBows) {
    for (const double t : {0.0, 25.0, 60.0, 90.0}) {
      double last = std::numeric_limits<double>::infinity();
      for (int order = 1; order <= 4; ++order) {
        const SlowState slow = slowState(p, t, order);
        const ShotState slope = shotDerivative(p, t, {slow.alpha, slow.moment, 0.0, 0.0});
        const double error = (slow.derivative.col(2) - Eigen::Vector2d(slope.alpha, slope.moment)).norm();
        EXPECT_LT(error, std::max(0.2 * last, 1e-14));
        last = error;
      }
      EXPECT_LT(last, 1e-11);
    }
  }
}

TEST(SlowManifold, DerivativesAreThoseOfDifferences) {
  constexpr double d = 1e-5;
  constexpr double t0 = 3.0, t1 = 80.0;
  for (const ShotParameters& p : kBows) {
    const SlowState state = slowState(p, t0, 3);
    const SlowStretch stretch = slowStretch(p, t0, t1, 3);
    for (int j = 0; j < 4; ++j) {
      const auto moved = [&](double by) {
        ShotParameters q = p;
        if (j == 0) q.h += by;
        if (j == 1) q.v += by;
        const double from = j == 2 ? t0 + by : t0;
        const double to = j == 3 ? t1 + by : t1;
        const SlowState at = slowState(q, from, 3);
        const Eigen::Vector2d end = slowStretch(q, from, to, 3).displacement;
        return Eigen::Vector4d(at.alpha, at.moment, end.x(), end.y());
      };
      const Eigen::Vector4d quotient = (moved(d) - moved(-d)) / (2.0 * d);
      if (j < 3) {
        EXPECT_LT((quotient.head<2>() - state.derivative.col(j)).norm(), 1e-9);
      }
      EXPECT_LT((quotient.tail<2>() - stretch.derivative.col(j)).norm(), 1e-7 * (1.0 + quotient.tail<2>().norm()));
    }
  }
}

TEST(SlowManifold, StretchesAreSumsOfItsSlopes) {
  constexpr int kIntervals = 4000;  // of Simpson's rule
  constexpr double t0 = 3.0, t1 = 80.0;
  for (const ShotParameters& p : kBows) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (int i = 0; i <= kIntervals; ++i) {
      const double t = t0 + (t1 - t0) * i / kIntervals;
      const SlowState slow = slowState(p, t, 3);
      const ShotState slope = shotDerivative(p, t, {slow.alpha, slow.moment, 0.0, 0.0});
      const double weight = i == 0 || i == kIntervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += weight * (t1 - t0) / (3.0 * kIntervals) * Eigen::Vector2d(slope.x, slope.y);
    }
    EXPECT_LT((slowStretch(p, t0, t1, 3).displacement - sum).norm(), 1e-11);
    double t = t0;
    Eigen::Vector2d parts = Eigen::Vector2d::Zero();
    for (int i = 1; i <= 5; ++i) {
      const double next = atShareOfRise(p, t0, t1, 0.2 * i);
      EXPECT_GT(next, t);
      parts += slowStretch(p, t, next, 3).displacement;
      t = next;
    }
    EXPECT_EQ(t, t1);
    EXPECT_LT((slowStretch(p, t0, t1, 3).displacement - parts).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

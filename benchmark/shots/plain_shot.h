// The shot of src/cable/shot.cpp without variational equations, for any scalar: the same equations, pair, and step
// control, which looks at values only. Of doubles it is the bare pass; of jets, automatic differentiation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cable/shot.h"

namespace cdpr_kinetostatics {

template <typename T>
struct PlainParameters {
  T h, v;
  double q, eps;
};

template <typename T>
struct PlainState {
  T alpha, moment, x, y;
};

inline double valueOf(double a) { return a; }
template <typename T>
double valueOf(const T& jet) {
  return jet.a;
}

template <typename T>
class PlainShot {
 public:
  PlainShot(const PlainParameters<T>& parameters, double t0, const PlainState<T>& start)
      : p_(parameters), t_(t0), y_(start) {
    slope(t_, y_, &k_[0]);
  }

  const PlainState<T>& state() const { return y_; }

  // Takes one step, unless its error is too large; returns the error in units of the tolerance, infinite where the
  // state has left every physical range.
  double tryStep(double dt, double tolerance) {
    advance(dt);
    double alpha = 0.0;
    double moment = 0.0;
    for (int j = 0; j < kStages; ++j) {
      alpha += kError[j] * valueOf(k_[j].alpha);
      moment += kError[j] * valueOf(k_[j].moment);
    }
    const double error = dt * std::max(std::abs(alpha), std::abs(moment)) / tolerance;
    if (!physical() || !std::isfinite(error)) return std::numeric_limits<double>::infinity();
    if (error <= 1.0) accept(dt);
    return error;
  }

  // Takes one step; false where the state has left every physical range.
  bool step(double dt) {
    advance(dt);
    if (!physical()) return false;
    accept(dt);
    return true;
  }

 private:
  static constexpr int kStages = 7;
  static constexpr double kC[kStages] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
  static constexpr double kA[kStages][kStages - 1] = {
      {},
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {44.0 / 45, -56.0 / 15, 32.0 / 9},
      {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
      {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
      {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  static constexpr double kError[kStages] = {71.0 / 57600,      0.0,          -71.0 / 16695, 71.0 / 1920,
                                             -17253.0 / 339200, 22.0 / 525.0, -1.0 / 40};

  void slope(double t, const PlainState<T>& y, PlainState<T>* d) const {
    using std::cos;
    using std::sin;
    const T c = cos(y.alpha);
    const T s = sin(y.alpha);
    const T v = p_.v - p_.q * t;
    const T e = 1.0 + p_.eps * (p_.h * c - v * s);
    d->alpha = e * y.moment;
    d->moment = e * (p_.h * s + v * c);
    d->x = e * c;
    d->y = e * s;
  }

  // x and y do not feed back: they are summed at the end of the step only.
  void advance(double h) {
    for (int i = 1; i < kStages; ++i) {
      next_.alpha = y_.alpha;
      next_.moment = y_.moment;
      for (int j = 0; j < i; ++j) {
        next_.alpha += h * kA[i][j] * k_[j].alpha;
        next_.moment += h * kA[i][j] * k_[j].moment;
      }
      slope(t_ + kC[i] * h, next_, &k_[i]);
    }
    next_.x = y_.x;
    next_.y = y_.y;
    for (int j = 0; j < kStages - 1; ++j) {
      next_.x += h * kA[kStages - 1][j] * k_[j].x;
      next_.y += h * kA[kStages - 1][j] * k_[j].y;
    }
  }

  bool physical() const { return std::abs(valueOf(next_.alpha)) < 100.0 && std::abs(valueOf(next_.moment)) < 1e6; }

  void accept(double dt) {
    y_ = next_;
    t_ += dt;
    k_[0] = k_[kStages - 1];
  }

  const PlainParameters<T> p_;
  double t_;
  PlainState<T> y_;
  PlainState<T> next_;
  std::array<PlainState<T>, kStages> k_;
};

// Chooses the steps as shootAdaptive() does; visit(state) after each. False where that rejects the shot.
template <typename T, typename Visit>
bool shootPlainAdaptive(const PlainParameters<T>& parameters, double t0, double t1, const PlainState<T>& start,
                        double tolerance, StepGrid* grid, PlainState<T>* end, const Visit& visit) {
  constexpr int kMaxSteps = 4000;
  constexpr double kLongestStep = 0.5;
  PlainShot<T> shot(parameters, t0, start);
  double h = grid->empty() ? 0.5 : grid->front();
  grid->clear();
  double t = t0;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double left = t1 - t;
    h = std::min(h, kLongestStep);
    const bool last = h >= left;
    const double dt = last ? left : std::min(h, h > 0.5 * left ? 0.5 * left : h);
    const double error = shot.tryStep(dt, tolerance);
    if (std::isinf(error)) {
      h = 0.2 * dt;
      if (h < 1e-10) return false;
      continue;
    }
    if (error <= 1.0) {
      t += dt;
      grid->push_back(dt);
      visit(shot.state());
      if (last) {
        *end = shot.state();
        return true;
      }
    }
    h = dt * std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 5.0);
  }
  return false;
}

template <typename T, typename Visit>
bool shootPlainOnGrid(const PlainParameters<T>& parameters, double t0, const PlainState<T>& start, const StepGrid& grid,
                      double scale, PlainState<T>* end, const Visit& visit) {
  PlainShot<T> shot(parameters, t0, start);
  for (const double dt : grid) {
    if (!shot.step(scale * dt)) return false;
    visit(shot.state());
  }
  *end = shot.state();
  return true;
}

}  // namespace cdpr_kinetostatics

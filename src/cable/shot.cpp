#include "cdpr_kinetostatics/cable/shot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxSteps = 4000;
constexpr int kStages = 7;

// Longest step, in bending layers: where the state is exactly straight its error says nothing about that of
// the sensitivities.
constexpr double kLongestStep = 0.5;

// Layout of the integrated rows: what feeds back first (alpha, moment and their derivatives with respect
// to alpha0, moment0, h, v), then the quadratures (x, w and theirs).
constexpr int kFeedback = 10;
constexpr int kRows = 20;
enum Row { kAlpha = 0, kMoment = 1, kDAlpha = 2, kDMoment = 6, kX = 10, kW = 11, kDX = 12, kDW = 16 };
using Rows = std::array<double, kRows>;

// Dormand, Prince (1980): coefficients of the pair of orders 5 and 4.
constexpr double kC[kStages] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
constexpr double kA[kStages][kStages - 1] = {{},
                                             {1.0 / 5},
                                             {3.0 / 40, 9.0 / 40},
                                             {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                             {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                             {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                             {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
constexpr double kError[kStages] = {71.0 / 57600,      0.0,          -71.0 / 16695, 71.0 / 1920,
                                    -17253.0 / 339200, 22.0 / 525.0, -1.0 / 40};

void derivative(const ShotParameters& p, double t, const Rows& y, Rows* dy) {
  const double c = std::cos(y[kAlpha]);
  const double s = std::sin(y[kAlpha]);
  const double v = p.v - p.q * t;
  const double tension = p.h * c - v * s;
  const double shear = p.h * s + v * c;
  const double e = 1.0 + p.eps * tension;
  const double m = y[kMoment];
  Rows& d = *dy;
  d[kAlpha] = e * m;
  d[kMoment] = e * shear;
  d[kX] = e * c;
  d[kW] = e * s;
  for (int j = 0; j < 4; ++j) {
    const double da = y[kDAlpha + j];
    const double direct_t = j == 2 ? c : j == 3 ? -s : 0.0;
    const double direct_s = j == 2 ? s : j == 3 ? c : 0.0;
    const double de = p.eps * (direct_t - shear * da);
    d[kDAlpha + j] = e * y[kDMoment + j] + m * de;
    d[kDMoment + j] = e * (tension * da + direct_s) + shear * de;
    d[kDX + j] = c * de - e * s * da;
    d[kDW + j] = s * de + e * c * da;
  }
}

Rows initialRows(const ShotState& start) {
  Rows y{};
  y[kAlpha] = start.alpha;
  y[kMoment] = start.moment;
  y[kX] = start.x;
  y[kW] = start.w;
  y[kDAlpha] = 1.0;
  y[kDMoment + 1] = 1.0;
  return y;
}

void finish(const Rows& y, Shot* shot) {
  shot->end = {y[kAlpha], y[kMoment], y[kX], y[kW]};
  for (int j = 0; j < 4; ++j) {
    shot->sensitivity(0, j) = y[kDAlpha + j];
    shot->sensitivity(1, j) = y[kDMoment + j];
    shot->sensitivity(2, j) = y[kDX + j];
    shot->sensitivity(3, j) = y[kDW + j];
  }
}

// One step from (t, y) with k[0] known; leaves the new derivative in k[6] (first same as last).
void step(const ShotParameters& p, double t, double h, const Rows& y, std::array<Rows, kStages>* stages, Rows* next) {
  std::array<Rows, kStages>& k = *stages;
  Rows stage;
  for (int i = 1; i < kStages; ++i) {
    const int rows = i == kStages - 1 ? kRows : kFeedback;
    for (int r = 0; r < rows; ++r) {
      double sum = 0.0;
      for (int j = 0; j < i; ++j) sum += kA[i][j] * k[j][r];
      stage[r] = y[r] + h * sum;
    }
    derivative(p, t + kC[i] * h, stage, &k[i]);
  }
  *next = stage;
}

constexpr IntegrationWork kFirstDerivative = {0, 1};
constexpr IntegrationWork kOneStep = {1, kStages - 1};

bool physical(const Rows& y) { return std::abs(y[kAlpha]) < 100.0 && std::abs(y[kMoment]) < 1e6; }

}  // namespace

ShotState shotDerivative(const ShotParameters& p, double t, const ShotState& state) {
  const double c = std::cos(state.alpha);
  const double s = std::sin(state.alpha);
  const double v = p.v - p.q * t;
  const double e = 1.0 + p.eps * (p.h * c - v * s);
  return {e * state.moment, e * (p.h * s + v * c), e * c, e * s};
}

bool shootAdaptive(const ShotParameters& p, double t0, double t1, const ShotState& start,
                   const ShotTolerance& tolerance, StepGrid* grid, Shot* shot) {
  Rows y = initialRows(start);
  Rows next;
  std::array<Rows, kStages> k;
  derivative(p, t0, y, &k[0]);
  double h = grid->empty() ? 0.5 : grid->front();
  grid->clear();
  shot->turning.clear();
  shot->work = kFirstDerivative;
  double t = t0;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double left = t1 - t;
    h = std::min(h, kLongestStep);
    // Two halves rather than a whole step and a sliver.
    const bool last = h >= left;
    const double dt = last ? left : std::min(h, h > 0.5 * left ? 0.5 * left : h);
    step(p, t, dt, y, &k, &next);
    shot->work += kOneStep;
    double error_alpha = 0.0;
    double error_moment = 0.0;
    for (int j = 0; j < kStages; ++j) {
      error_alpha += kError[j] * k[j][kAlpha];
      error_moment += kError[j] * k[j][kMoment];
    }
    const double error =
        dt * std::max(std::abs(error_alpha) / tolerance.alpha, std::abs(error_moment) / tolerance.moment);
    if (!std::isfinite(error) || !physical(next)) {
      h = 0.2 * dt;
      if (h < 1e-10) return false;
      continue;
    }
    const double factor = std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 5.0);
    if (error <= 1.0) {
      y = next;
      t += dt;
      k[0] = k[kStages - 1];
      grid->push_back(dt);
      shot->turning.emplace_back(y[kDAlpha], y[kDAlpha + 1]);
      if (last) {
        finish(y, shot);
        return true;
      }
    }
    h = dt * factor;
  }
  return false;
}

bool shootOnGrid(const ShotParameters& p, double t0, const ShotState& start, const StepGrid& grid, double scale,
                 Shot* shot) {
  Rows y = initialRows(start);
  std::array<Rows, kStages> k;
  Rows next;
  derivative(p, t0, y, &k[0]);
  shot->turning.clear();
  shot->work = kFirstDerivative;
  double t = t0;
  for (const double recorded : grid) {
    const double dt = scale * recorded;
    step(p, t, dt, y, &k, &next);
    shot->work += kOneStep;
    if (!physical(next)) return false;
    y = next;
    t += dt;
    k[0] = k[kStages - 1];
    shot->turning.emplace_back(y[kDAlpha], y[kDAlpha + 1]);
  }
  finish(y, shot);
  return true;
}

}  // namespace cdpr_kinetostatics

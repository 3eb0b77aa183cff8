#include "cable/shot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cdpr_kinetostatics {
namespace {

// A shot is rejected after so many steps: a segment of three layers takes ten to thirty, and one that takes a hundred
// times as many is on its way to nowhere.
constexpr int kMaxSteps = 4000;

constexpr int kStages = 7;

// A step that led to a state beyond these bounds, or to no number, is tried again with this share of its length, until
// it would be shorter than kShortestStep [layers].
constexpr double kLargestAngle = 100.0;  // [rad]: sixteen turns, while a cable without loops has less than one
constexpr double kLargestMoment = 1e6;   // in its unit: the moment of a bend a million times sharper than a layer
constexpr double kRetryShare = 0.2;
constexpr double kShortestStep = 1e-10;

// Step control: a share of the step at which the error would be the tolerance, by the order of the error; the step
// grows or shrinks by at most a factor of 5 at a time. These are the values of Hairer, Norsett, Wanner: Solving
// Ordinary Differential Equations I, section II.4. Errors below the least one ask for the largest growth anyway.
constexpr double kSafety = 0.9;
constexpr double kErrorExponent = -0.2;
constexpr double kMostShrinking = 0.2;
constexpr double kMostGrowth = 5.0;
constexpr double kLeastError = 1e-10;

// First step of a segment that was not shot before [layers].
constexpr double kFirstStep = 0.5;

// Longest step, in bending layers: where the state is exactly straight its error says nothing about that of
// the sensitivities.
constexpr double kLongestStep = 0.5;

// Layout of the integrated rows: what feeds back first (alpha, moment and their derivatives with respect
// to alpha0, moment0, h, v), then the quadratures (x, y and theirs).
constexpr int kFeedback = 10;
constexpr int kRows = 20;
enum Row { kAlpha = 0, kMoment = 1, kDAlpha = 2, kDMoment = 6, kX = 10, kY = 11, kDX = 12, kDY = 16 };
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

// (16) and (17).
void derivative(const ShotParameters& p, double t, const Rows& u, Rows* du) {
  const double c = std::cos(u[kAlpha]);
  const double s = std::sin(u[kAlpha]);
  const double v = p.v - p.q * t;
  const double tension = p.h * c - v * s;
  const double shear = p.h * s + v * c;
  const double e = 1.0 + p.eps * tension;
  const double m = u[kMoment];
  Rows& d = *du;
  d[kAlpha] = e * m;
  d[kMoment] = e * shear;
  d[kX] = e * c;
  d[kY] = e * s;
  const double direct_t[4] = {0.0, 0.0, c, -s};
  const double direct_s[4] = {0.0, 0.0, s, c};
  for (int j = 0; j < 4; ++j) {
    const double da = u[kDAlpha + j];
    const double de = p.eps * (direct_t[j] - shear * da);
    d[kDAlpha + j] = e * u[kDMoment + j] + m * de;
    d[kDMoment + j] = e * (tension * da + direct_s[j]) + shear * de;
    d[kDX + j] = c * de - e * s * da;
    d[kDY + j] = s * de + e * c * da;
  }
}

Rows initialRows(const ShotState& start) {
  Rows u{};
  u[kAlpha] = start.alpha;
  u[kMoment] = start.moment;
  u[kX] = start.x;
  u[kY] = start.y;
  u[kDAlpha] = 1.0;
  u[kDMoment + 1] = 1.0;
  return u;
}

void finish(const Rows& u, Shot* shot) {
  shot->end = {u[kAlpha], u[kMoment], u[kX], u[kY]};
  for (int j = 0; j < 4; ++j) {
    shot->sensitivity(0, j) = u[kDAlpha + j];
    shot->sensitivity(1, j) = u[kDMoment + j];
    shot->sensitivity(2, j) = u[kDX + j];
    shot->sensitivity(3, j) = u[kDY + j];
  }
}

using Stages = std::array<Rows, kStages>;

// The first kCount rows of u + h times the sum of the stages before kStage. It is unrolled by hand so that the compiler
// makes vector instructions of it.
template <int kStage, int kCount>
void advance(double h, const Rows& u, const Stages& k, Rows* result) {
  for (int r = 0; r < kCount; ++r) {
    double sum = kA[kStage][0] * k[0][r];
    if constexpr (kStage > 1 && kStage < 6) sum += kA[kStage][1] * k[1][r];
    if constexpr (kStage > 2) sum += kA[kStage][2] * k[2][r];
    if constexpr (kStage > 3) sum += kA[kStage][3] * k[3][r];
    if constexpr (kStage > 4) sum += kA[kStage][4] * k[4][r];
    if constexpr (kStage > 5) sum += kA[kStage][5] * k[5][r];
    (*result)[r] = u[r] + h * sum;
  }
}

// One step from (t, u) with k[0] known; leaves the new derivative in k[6] (first same as last).
void step(const ShotParameters& p, double t, double h, const Rows& u, Stages* stages, Rows* next) {
  Stages& k = *stages;
  Rows stage;
  advance<1, kFeedback>(h, u, k, &stage);
  derivative(p, t + kC[1] * h, stage, &k[1]);
  advance<2, kFeedback>(h, u, k, &stage);
  derivative(p, t + kC[2] * h, stage, &k[2]);
  advance<3, kFeedback>(h, u, k, &stage);
  derivative(p, t + kC[3] * h, stage, &k[3]);
  advance<4, kFeedback>(h, u, k, &stage);
  derivative(p, t + kC[4] * h, stage, &k[4]);
  advance<5, kFeedback>(h, u, k, &stage);
  derivative(p, t + kC[5] * h, stage, &k[5]);
  advance<6, kRows>(h, u, k, next);
  derivative(p, t + h, *next, &k[6]);
}

// The larger of the errors of alpha and of the moment, by the difference of the pair of orders 5 and 4.
double errorOf(double h, const Stages& k) {
  double alpha = 0.0;
  double moment = 0.0;
  for (int j = 0; j < kStages; ++j) {
    alpha += kError[j] * k[j][kAlpha];
    moment += kError[j] * k[j][kMoment];
  }
  return std::max(std::abs(h * alpha), std::abs(h * moment));
}

constexpr IntegrationWork kFirstDerivative = {0, 1};
constexpr IntegrationWork kOneStep = {1, kStages - 1};

void begin(Shot* shot) {
  shot->turning.clear();
  shot->step_error = 0.0;
  shot->work = kFirstDerivative;
}

// An accepted step.
void record(const Rows& u, double error, Shot* shot) {
  shot->turning.emplace_back(u[kDAlpha], u[kDAlpha + 1]);
  shot->step_error = std::max(shot->step_error, error);
}

bool physical(const Rows& u) { return std::abs(u[kAlpha]) < kLargestAngle && std::abs(u[kMoment]) < kLargestMoment; }

}  // namespace

ShotState shotDerivative(const ShotParameters& p, double t, const ShotState& state) {
  const double c = std::cos(state.alpha);
  const double s = std::sin(state.alpha);
  const double v = p.v - p.q * t;
  const double e = 1.0 + p.eps * (p.h * c - v * s);
  return {e * state.moment, e * (p.h * s + v * c), e * c, e * s};
}

bool shootAdaptive(const ShotParameters& p, double t0, double t1, const ShotState& start, double tolerance,
                   StepGrid* grid, Shot* shot) {
  Rows u = initialRows(start);
  Rows next;
  Stages k;
  derivative(p, t0, u, &k[0]);
  double h = grid->empty() ? kFirstStep : grid->front();
  grid->clear();
  begin(shot);
  double t = t0;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double left = t1 - t;
    h = std::min(h, kLongestStep);
    // Two halves rather than a whole step and a sliver.
    const bool last = h >= left;
    const double dt = last ? left : std::min(h, h > 0.5 * left ? 0.5 * left : h);
    step(p, t, dt, u, &k, &next);
    shot->work += kOneStep;
    const double step_error = errorOf(dt, k);
    const double error = step_error / tolerance;
    if (!std::isfinite(error) || !physical(next)) {
      h = kRetryShare * dt;
      if (h < kShortestStep) return false;
      continue;
    }
    const double factor =
        std::clamp(kSafety * std::pow(std::max(error, kLeastError), kErrorExponent), kMostShrinking, kMostGrowth);
    if (error <= 1.0) {
      u = next;
      t += dt;
      k[0] = k[kStages - 1];
      grid->push_back(dt);
      record(u, step_error, shot);
      if (last) {
        finish(u, shot);
        return true;
      }
    }
    h = dt * factor;
  }
  return false;
}

bool shootOnGrid(const ShotParameters& p, double t0, const ShotState& start, const StepGrid& grid, double scale,
                 Shot* shot) {
  Rows u = initialRows(start);
  Stages k;
  Rows next;
  derivative(p, t0, u, &k[0]);
  begin(shot);
  double t = t0;
  for (const double recorded : grid) {
    const double dt = scale * recorded;
    step(p, t, dt, u, &k, &next);
    shot->work += kOneStep;
    if (!physical(next)) return false;
    u = next;
    t += dt;
    record(u, errorOf(dt, k), shot);
    k[0] = k[kStages - 1];
  }
  finish(u, shot);
  return true;
}

}  // namespace cdpr_kinetostatics

// Shots whose derivatives are obtained otherwise than by the variational equations of src/cable/shot.cpp: by
// automatic differentiation of the integrator, or by differences on the steps of an undisturbed pass. Signatures are
// those of shot.h.
#pragma once

#include <ceres/jet.h>

#include <vector>

#include "shots/plain_shot.h"

namespace cdpr_kinetostatics {

class AutomaticShot {
  using Jet = ceres::Jet<double, 4>;  // (alpha0, moment0, h, v)

  static PlainParameters<Jet> seeded(const ShotParameters& p) { return {Jet(p.h, 2), Jet(p.v, 3), p.q, p.eps}; }
  static PlainState<Jet> seeded(const ShotState& s) { return {Jet(s.alpha, 0), Jet(s.moment, 1), Jet(s.x), Jet(s.y)}; }
  static auto recordTurning(Shot* shot) {
    return [shot](const PlainState<Jet>& y) { shot->turning.emplace_back(y.alpha.v[0], y.alpha.v[1]); };
  }

 public:
  static bool adaptive(const ShotParameters& p, double t0, double t1, const ShotState& start, double tolerance,
                       StepGrid* grid, Shot* shot) {
    shot->turning.clear();
    PlainState<Jet> end;
    if (!shootPlainAdaptive(seeded(p), t0, t1, seeded(start), tolerance, grid, &end, recordTurning(shot))) return false;
    finish(end, shot);
    return true;
  }

  static bool onGrid(const ShotParameters& p, double t0, const ShotState& start, const StepGrid& grid, double scale,
                     Shot* shot) {
    shot->turning.clear();
    PlainState<Jet> end;
    if (!shootPlainOnGrid(seeded(p), t0, seeded(start), grid, scale, &end, recordTurning(shot))) return false;
    finish(end, shot);
    return true;
  }

 private:
  static void finish(const PlainState<Jet>& end, Shot* shot) {
    shot->end = {end.alpha.a, end.moment.a, end.x.a, end.y.a};
    shot->sensitivity << end.alpha.v.transpose(), end.moment.v.transpose(), end.x.v.transpose(), end.y.v.transpose();
  }
};

// Forward differences: the pass itself and one for each of the four parameters.
class DifferencesShot {
  static constexpr double kDifference = 1e-8;  // of quantities of order one

  static PlainParameters<double> plain(const ShotParameters& p) { return {p.h, p.v, p.q, p.eps}; }
  static PlainState<double> plain(const ShotState& s) { return {s.alpha, s.moment, s.x, s.y}; }
  static auto record(std::vector<double>* angles) {
    return [angles](const PlainState<double>& y) { angles->push_back(y.alpha); };
  }

 public:
  static bool adaptive(const ShotParameters& p, double t0, double t1, const ShotState& start, double tolerance,
                       StepGrid* grid, Shot* shot) {
    PlainState<double> end;
    std::vector<double> angles;
    if (!shootPlainAdaptive(plain(p), t0, t1, plain(start), tolerance, grid, &end, record(&angles))) return false;
    return differences(p, t0, start, *grid, 1.0, end, angles, shot);
  }

  static bool onGrid(const ShotParameters& p, double t0, const ShotState& start, const StepGrid& grid, double scale,
                     Shot* shot) {
    PlainState<double> end;
    std::vector<double> angles;
    angles.reserve(grid.size());
    if (!shootPlainOnGrid(plain(p), t0, plain(start), grid, scale, &end, record(&angles))) return false;
    return differences(p, t0, start, grid, scale, end, angles, shot);
  }

 private:
  static bool differences(const ShotParameters& p, double t0, const ShotState& start, const StepGrid& grid,
                          double scale, const PlainState<double>& end, const std::vector<double>& angles, Shot* shot) {
    shot->end = {end.alpha, end.moment, end.x, end.y};
    shot->turning.resize(angles.size());
    for (int j = 0; j < 4; ++j) {
      PlainParameters<double> moved_p = plain(p);
      PlainState<double> moved = plain(start);
      (j == 0 ? moved.alpha : j == 1 ? moved.moment : j == 2 ? moved_p.h : moved_p.v) += kDifference;
      PlainState<double> moved_end;
      std::size_t k = 0;
      const auto turn = [&](const PlainState<double>& y) {
        if (j < 2) shot->turning[k][j] = (y.alpha - angles[k]) / kDifference;
        ++k;
      };
      if (!shootPlainOnGrid(moved_p, t0, moved, grid, scale, &moved_end, turn)) return false;
      shot->sensitivity.col(j) = Eigen::Vector4d(moved_end.alpha - end.alpha, moved_end.moment - end.moment,
                                                 moved_end.x - end.x, moved_end.y - end.y) /
                                 kDifference;
    }
    return true;
  }
};

}  // namespace cdpr_kinetostatics

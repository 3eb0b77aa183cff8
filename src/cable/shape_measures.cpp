// What a converged bending cable looks like: its measures and its profile.
#include <algorithm>
#include <cmath>

#include "cdpr_kinetostatics/cable/multiple_shooting.h"

namespace cdpr_kinetostatics {
namespace {

struct Sample {
  double value = 0.0;
  double slope = 0.0;
};

// Largest magnitude of the cubic that has these values and slopes at the ends of an interval of length h.
double largestOfCubic(const Sample& a, const Sample& b, double h) {
  const double c1 = h * a.slope;
  const double c2 = 3.0 * (b.value - a.value) - h * (2.0 * a.slope + b.slope);
  const double c3 = 2.0 * (a.value - b.value) + h * (a.slope + b.slope);
  double largest = std::max(std::abs(a.value), std::abs(b.value));
  const double discriminant = c2 * c2 - 3.0 * c1 * c3;
  if (discriminant < 0.0) return largest;
  // Roots of c1 + 2 c2 u + 3 c3 u^2, without cancellation.
  const double root = -(c2 + std::copysign(std::sqrt(discriminant), c2));
  for (const double u : {root / (3.0 * c3), c1 / root}) {
    if (u > 0.0 && u < 1.0) largest = std::max(largest, std::abs(a.value + u * (c1 + u * (c2 + u * c3))));
  }
  return largest;
}

// The quantities whose extremes are wanted, with their derivatives with respect to t.
struct Local {
  Local(const ShotParameters& p, double t, const ShotState& y, double chord_angle) {
    const double c = std::cos(y.alpha);
    const double s = std::sin(y.alpha);
    const double v = p.v - p.q * t;
    const double force_t = p.h * c - v * s;
    const double force_s = p.h * s + v * c;
    const double e = 1.0 + p.eps * force_t;
    tension = {force_t, p.q * s - force_s * e * y.moment};
    shear = {force_s, force_t * e * y.moment - p.q * c};
    moment = {y.moment, e * force_s};
    offset = {y.x * std::sin(chord_angle) - y.w * std::cos(chord_angle), e * std::sin(chord_angle - y.alpha)};
  }
  Sample tension, shear, moment, offset;
};

}  // namespace

void MultipleShooting::measure(int profile_points, CableSolution* solution) const {
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  const double grid_scale = length_ / grid_length_;
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  for (const Segment& segment : segments_) end += Eigen::Vector2d(segment.shot.end.x, segment.shot.end.w);
  const double chord_angle = std::atan2(end.y(), end.x());

  double stretch = 0.0;
  double sag = 0.0;
  double max_moment = 0.0;
  double max_shear = 0.0;
  solution->profile.clear();
  const auto addPoint = [&](double t, const ShotState& y) {
    const Local local(p, t, y, chord_angle);
    solution->profile.push_back({t * reference_length_, y.x * reference_length_, y.w * reference_length_, y.alpha,
                                 y.moment * reference_moment_, local.tension.value * reference_force_,
                                 -local.shear.value * reference_force_});
  };

  Shot shot;
  ShotState state{segments_.front().node.x(), segments_.front().node.y(), 0.0, 0.0};
  for (const Segment& segment : segments_) {
    double t = segment.begin * span;
    state.alpha = segment.node.x();
    state.moment = segment.node.y();
    for (const double recorded : segment.grid) {
      const double dt = grid_scale * recorded;
      shootOnGrid(p, t, state, {recorded}, grid_scale, &shot);
      const Local from(p, t, state, chord_angle);
      const Local to(p, t + dt, shot.end, chord_angle);
      stretch +=
          0.5 * dt * (from.tension.value + to.tension.value) + dt * dt / 12.0 * (from.tension.slope - to.tension.slope);
      sag = std::max(sag, largestOfCubic(from.offset, to.offset, dt));
      max_moment = std::max(max_moment, largestOfCubic(from.moment, to.moment, dt));
      max_shear = std::max(max_shear, largestOfCubic(from.shear, to.shear, dt));
      while (static_cast<int>(solution->profile.size()) < profile_points - 1) {
        const double sample = span * static_cast<double>(solution->profile.size()) / (profile_points - 1);
        if (sample > t + dt) break;
        Shot inside;
        shootOnGrid(p, t, state, {sample - t}, 1.0, &inside);
        addPoint(sample, inside.end);
      }
      t += dt;
      state = shot.end;
    }
  }
  if (profile_points > 0) addPoint(span, state);
  solution->x = state.x * reference_length_;
  solution->w = state.w * reference_length_;
  solution->strained_length = length_ + p.eps * stretch * reference_length_;
  solution->angle_a = segments_.front().node.x();
  solution->angle_b = last_node_.x();
  solution->sag = sag * reference_length_;
  solution->max_moment = max_moment * reference_moment_;
  solution->max_shear = max_shear * reference_force_;
}

}  // namespace cdpr_kinetostatics

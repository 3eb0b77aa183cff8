// What a converged bending cable looks like: its measures and its profile.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cable/catenary.h"
#include "cable/multiple_shooting.h"

namespace cdpr_kinetostatics {
namespace {

// The middle is walked along in pieces in which the force turns by at most this angle [rad], and grows by at most
// this share.
constexpr double kRisePerPiece = 0.2;
constexpr double kFewestPieces = 4.0;
// Below this turn a cubic is enough for the area between the middle and its chord.
constexpr double kRiseOfOneArc = 0.05;

struct Sample {
  double value = 0.0;
  double slope = 0.0;
};

// Where the cubic that has these values and slopes at the ends of an interval of length h is extreme, as shares
// of the interval; outside (0, 1) where it is monotonic.
std::array<double, 2> extremesOfCubic(const Sample& a, const Sample& b, double h) {
  const double c1 = h * a.slope;
  const double c2 = 3.0 * (b.value - a.value) - h * (2.0 * a.slope + b.slope);
  const double c3 = 2.0 * (a.value - b.value) + h * (a.slope + b.slope);
  const double discriminant = c2 * c2 - 3.0 * c1 * c3;
  if (discriminant < 0.0) return {-1.0, -1.0};
  // Roots of c1 + 2 c2 u + 3 c3 u^2, without cancellation.
  const double root = -(c2 + std::copysign(std::sqrt(discriminant), c2));
  return {root / (3.0 * c3), c1 / root};
}

// The quantities whose extremes are wanted, with their derivatives with respect to t.
struct Local {
  Local(const ShotParameters& p, double t, const ShotState& at, double chord_angle) {
    const double c = std::cos(at.alpha);
    const double s = std::sin(at.alpha);
    const double v = p.v - p.q * t;
    const double force_t = p.h * c - v * s;
    const double force_s = p.h * s + v * c;
    const double e = 1.0 + p.eps * force_t;
    tension = {force_t, p.q * s - force_s * e * at.moment};
    shear = {force_s, force_t * e * at.moment - p.q * c};
    moment = {at.moment, e * force_s};
    offset = {at.x * std::sin(chord_angle) - at.y * std::cos(chord_angle), e * std::sin(chord_angle - at.alpha)};
  }
  Sample tension, shear, moment, offset;
};

}  // namespace

// Collects the measures of a shape that is walked along from A to B, interval by interval, in the shooting's units.
struct ShapeMeter {
  const ShotParameters p;
  const double chord_angle;
  const double span;
  const int profile_points;

  double stretch = 0.0;
  double sag = 0.0;
  double max_moment = 0.0;
  double max_shear = 0.0;
  std::vector<ProfilePoint> profile;

  Local localAt(double t, const ShotState& state) const { return Local(p, t, state, chord_angle); }

  void addPoint(double t, const ShotState& at) {
    const Local local = localAt(t, at);
    profile.push_back({t, at.x, at.y, at.alpha, at.moment, local.tension.value, -local.shear.value});
  }

  // An interval at whose ends the state is known; inside(t) is the state between.
  template <typename Inside>
  void addInterval(double t, const Local& from, double dt, const Local& to, const Inside& inside) {
    const auto raise = [&](Sample Local::*quantity, double* largest) {
      *largest = std::max({*largest, std::abs((from.*quantity).value), std::abs((to.*quantity).value)});
      for (const double share : extremesOfCubic(from.*quantity, to.*quantity, dt)) {
        if (!(share > 0.0 && share < 1.0)) continue;
        const double at = t + share * dt;
        *largest = std::max(*largest, std::abs((localAt(at, inside(at)).*quantity).value));
      }
    };
    raise(&Local::offset, &sag);
    raise(&Local::moment, &max_moment);
    raise(&Local::shear, &max_shear);
    while (static_cast<int>(profile.size()) < profile_points - 1) {
      const double sample = span * static_cast<double>(profile.size()) / (profile_points - 1);
      if (sample > t + dt) break;
      addPoint(sample, inside(sample));
    }
  }
};

// The state at t in the middle, with what is left of the modes of its ends; (x, y) counted on from another.
ShotState MultipleShooting::middleState(const Segment& middle, double t_from, const ShotState& from, double t) const {
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  const SlowState slow = slowState(p, t, slow_order_);
  const double from_begin = middle.node.x() - middle.slow_begin.alpha;
  const double from_end = middle.shot.end.alpha - middle.slow_end.alpha;
  const auto ahead = [&](double at) {
    return from_begin *
           std::exp(-middle.slow_begin.decay * (1.0 + p.eps * middle.slow_begin.tension) * (at - middle.begin * span));
  };
  const auto behind = [&](double at) {
    return from_end *
           std::exp(-middle.slow_end.growth * (1.0 + p.eps * middle.slow_end.tension) * (middle.end * span - at));
  };
  const Eigen::Vector2d along = slowStretch(p, t_from, t, slow_order_).displacement +
                                middle.slow_begin.ahead * (ahead(t_from) - ahead(t)) +
                                middle.slow_end.behind * (behind(t) - behind(t_from));
  return {slow.alpha + ahead(t) + behind(t), slow.moment - slow.decay * ahead(t) + slow.growth * behind(t),
          from.x + along.x(), from.y + along.y()};
}

// The point of the middle with this slope; its beginning if there is none.
double MultipleShooting::whereSlopeIs(const Segment& middle, double angle) const {
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  double t = (p.v + p.h * std::tan(angle)) / p.q;  // the catenary's
  for (int i = 0; i < 4; ++i) {
    if (!(t > middle.begin * span && t < middle.end * span)) return middle.begin * span;
    const SlowState slow = slowState(p, t, slow_order_);
    const double step = (slow.alpha - angle) / slow.derivative(0, 2);
    t -= step;
    if (std::abs(step) < 1e-9 * span) break;
  }
  return std::clamp(t, middle.begin * span, middle.end * span);
}

// Where the last of a bending layer's moment balances the rise of the middle's: an extreme too slight for the cubics.
std::array<double, 2> MultipleShooting::whereTailsTurn(const Segment& middle) const {
  const double span = length_ / reference_length_;
  const double eps = parameters().eps;
  const auto distance = [&](const SlowState& slow, double mode, double angle) {
    const double rate = mode * (1.0 + eps * slow.tension);
    const double ratio = -mode * angle * rate / slow.derivative(1, 2);
    return ratio > 1.0 ? std::min(std::log(ratio) / rate, 0.5 * (middle.end - middle.begin) * span) : 0.0;
  };
  return {middle.begin * span +
              distance(middle.slow_begin, middle.slow_begin.decay, middle.node.x() - middle.slow_begin.alpha),
          middle.end * span -
              distance(middle.slow_end, middle.slow_end.growth, middle.shot.end.alpha - middle.slow_end.alpha)};
}

template <typename Visit>
void MultipleShooting::forEachPiece(const Segment& middle, ShotState from, const Visit& visit) const {
  const double span = length_ / reference_length_;
  const double begin = middle.begin * span;
  const double end = middle.end * span;
  const double rise = riseOfForce(parameters(), begin, end);
  const int count = static_cast<int>(std::ceil(std::max(rise / kRisePerPiece, kFewestPieces)));
  double t = begin;
  for (int i = 1; i <= count; ++i) {
    const double next = atShareOfRise(parameters(), begin, end, static_cast<double>(i) / count);
    const ShotState to = middleState(middle, t, from, next);
    visit(t, from, next - t, to);
    t = next;
    from = to;
  }
}

double MultipleShooting::areaBelowChord() const {
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  double area = 0.0;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  const auto addArc = [&](const Eigen::Vector2d& along, double angle_from, double angle_to) {
    const Eigen::Vector2d to = from + along;
    const double slope = std::atan2(along.y(), along.x());
    area += 0.5 * (from.x() * to.y() - from.y() * to.x()) +
            along.squaredNorm() / 12.0 * (std::sin(angle_to - slope) - std::sin(angle_from - slope));
    from = to;
  };
  for (const Segment& segment : segments_) {
    const ShotState begin{segment.node.x(), segment.node.y(), 0.0, 0.0};
    if (segment.quiet && riseOfForce(p, segment.begin * span, segment.end * span) <= kRiseOfOneArc) {
      addArc({segment.shot.end.x, segment.shot.end.y}, segment.slow_begin.alpha, segment.slow_end.alpha);
    } else if (segment.quiet) {
      forEachPiece(segment, begin, [&](double, const ShotState& a, double, const ShotState& b) {
        addArc({b.x - a.x, b.y - a.y}, a.alpha, b.alpha);
      });
    } else {
      addArc({segment.shot.end.x, segment.shot.end.y}, begin.alpha, segment.shot.end.alpha);
    }
  }
  return area * reference_length_ * reference_length_;
}

// Along the middle in closed form: extremes where the slope is that of the chord or of the horizontal, and where the
// tails of the bending layers turn.
ShotState MultipleShooting::measureMiddle(const Segment& segment, const ShotState& begin, ShapeMeter* meter) const {
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  const double t = segment.begin * span;
  const double length = (segment.end - segment.begin) * span;
  meter->stretch += catenaryStrainedLength({1.0, 0.0, p.q}, p.h, p.v - p.q * t, length) - length;
  const std::array<double, 2> tails = whereTailsTurn(segment);
  for (const double at : {whereSlopeIs(segment, meter->chord_angle), whereSlopeIs(segment, 0.0), tails[0], tails[1]}) {
    const Local extreme = meter->localAt(at, middleState(segment, t, begin, at));
    meter->sag = std::max(meter->sag, std::abs(extreme.offset.value));
    meter->max_moment = std::max(meter->max_moment, std::abs(extreme.moment.value));
  }
  ShotState state = begin;
  forEachPiece(segment, begin, [&](double from_t, const ShotState& from, double dt, const ShotState& to) {
    meter->addInterval(from_t, meter->localAt(from_t, from), dt, meter->localAt(from_t + dt, to),
                       [&](double sample) { return middleState(segment, from_t, from, sample); });
    state = to;
  });
  return state;
}

// Along a shot, step by step on its own grid.
ShotState MultipleShooting::measureShot(const Segment& segment, ShotState state, ShapeMeter* meter,
                                        IntegrationWork* work) const {
  const ShotParameters& p = meter->p;
  const double grid_scale = length_ / grid_length_;
  double t = segment.begin * meter->span;
  Shot shot;
  for (const double recorded : segment.grid) {
    const double dt = grid_scale * recorded;
    shootOnGrid(p, t, state, {recorded}, grid_scale, &shot);
    *work += shot.work;
    const Local from = meter->localAt(t, state);
    const Local to = meter->localAt(t + dt, shot.end);
    meter->stretch +=
        0.5 * dt * (from.tension.value + to.tension.value) + dt * dt / 12.0 * (from.tension.slope - to.tension.slope);
    meter->addInterval(t, from, dt, to, [&](double sample) {
      Shot inside;
      shootOnGrid(p, t, state, {sample - t}, 1.0, &inside);
      *work += inside.work;
      return inside.end;
    });
    t += dt;
    state = shot.end;
  }
  return state;
}

void MultipleShooting::measure(int profile_points, CableSolution* solution) const {
  const double span = length_ / reference_length_;
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  for (const Segment& segment : segments_) end += Eigen::Vector2d(segment.shot.end.x, segment.shot.end.y);
  ShapeMeter meter{parameters(), std::atan2(end.y(), end.x()), span, profile_points, 0.0, 0.0, 0.0, 0.0, {}};
  IntegrationWork work = work_;
  ShotState state{segments_.front().node.x(), segments_.front().node.y(), 0.0, 0.0};
  for (const Segment& segment : segments_) {
    state.alpha = segment.node.x();
    state.moment = segment.node.y();
    state = segment.quiet ? measureMiddle(segment, state, &meter) : measureShot(segment, state, &meter, &work);
  }
  if (profile_points > 0) meter.addPoint(span, state);
  solution->profile = std::move(meter.profile);
  for (ProfilePoint& point : solution->profile) {
    point.s *= reference_length_;
    point.x *= reference_length_;
    point.y *= reference_length_;
    point.moment *= reference_moment_;
    point.tension *= reference_force_;
    point.shear *= reference_force_;
  }
  solution->x = state.x * reference_length_;
  solution->y = state.y * reference_length_;
  solution->strained_length = length_ + meter.p.eps * meter.stretch * reference_length_;
  solution->angle_a = segments_.front().node.x();
  solution->angle_b = last_node_.x();
  solution->sag = meter.sag * reference_length_;
  solution->max_moment = meter.max_moment * reference_moment_;
  solution->max_shear = meter.max_shear * reference_force_;
  solution->integrator_steps = work.steps;
  solution->evaluations = work.evaluations;
}

}  // namespace cdpr_kinetostatics

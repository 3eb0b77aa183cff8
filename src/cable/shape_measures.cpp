#include "cable/shape_measures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cable/bounded_count.h"
#include "cable/catenary.h"
#include "cable/cubic_extremes.h"

namespace cdpr_kinetostatics {
namespace {

// A quiet segment is walked along in pieces in which the force turns by at most this angle [rad], and grows by at most
// this share; in at least kFewestPieces. The cubics between the pieces' ends then find sag and moment to 1e-5.
constexpr double kRisePerPiece = 0.2;
constexpr int kFewestPieces = 4;
constexpr int kMostPieces = 8000;  // the force grows by no more than 1e308 squared

// Below this turn [rad] one cubic is enough for the area between a quiet segment and its chord, whose sign alone
// counts.
constexpr double kRiseOfOneArc = 0.05;

// Newton's method for the point of a given slope: so many steps at most, or until they are this share of the length.
constexpr int kSlopeSteps = 4;
constexpr double kSlopeStepShare = 1e-9;

// Ends coincide from this share of the length on: rounding of a sum over segments.
constexpr double kCoinciding = 1e-13;

// The multiple of a turn that takes the angle at A, where a search may have wound it up, into (-pi, pi] [rad].
double wholeTurns(double angle_a) { return 2.0 * M_PI * std::ceil((angle_a - M_PI) / (2.0 * M_PI)); }

// The quantities whose extremes are wanted, with their derivatives with respect to t: (2), (3), the moment, and the
// distance from the chord.
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

// Walks along a quiet segment in pieces small enough for cubic interpolation: visit(t, state, dt, next state).
template <typename Visit>
void forEachPiece(const SegmentedCable& shape, const ShootingSegment& segment, ShotState from, const Visit& visit) {
  const ShotParameters p = shape.cable.parameters();
  const double span = shape.cable.span();
  const double begin = segment.begin * span;
  const double end = segment.end * span;
  const double rise = riseOfForce(p, begin, end);
  const int count = boundedCount(rise / kRisePerPiece, kFewestPieces, kMostPieces);
  double t = begin;
  for (int i = 1; i <= count; ++i) {
    const double next = atShareOfRise(p, begin, end, static_cast<double>(i) / count);
    const ShotState to = shape.quietStateAt(segment, t, from, next);
    visit(t, from, next - t, to);
    t = next;
    from = to;
  }
}

// Walks along the cable from A to B and keeps what is extreme, what adds up, and the profile's points. Units of shot.h,
// but for the profile, which is in SI units.
class ShapeWalk {
 public:
  ShapeWalk(const SegmentedCable& shape, int profile_points, std::vector<ProfilePoint>* profile)
      : shape_(shape),
        p_(shape.cable.parameters()),
        span_(shape.cable.span()),
        profile_points_(profile_points),
        profile_(profile),
        turns_(wholeTurns(shape.segments.front().node.x())) {
    Eigen::Vector2d end = Eigen::Vector2d::Zero();
    for (const ShootingSegment& segment : shape.segments) {
      end += Eigen::Vector2d(segment.shot.end.x, segment.shot.end.y);
    }
    // Ends that coincide have a chord without a direction: the one that their neighbours along x have.
    chord_angle_ = end.norm() > kCoinciding * span_ ? std::atan2(end.y(), end.x()) : 0.0;
    profile_->clear();
  }

  // (x, y) go on from segment to segment, angle and moment are those of the nodes.
  void run() {
    for (const ShootingSegment& segment : shape_.segments) {
      state_.alpha = segment.node.x();
      state_.moment = segment.node.y();
      segment.quiet ? walkQuiet(segment) : walkShot(segment);
    }
    if (profile_points_ > 0) addPoint(span_, state_);
  }

  const ShotState& end() const { return state_; }
  double turns() const { return turns_; }
  double stretch() const { return stretch_; }
  double sag() const { return sag_; }
  double maxMoment() const { return max_moment_; }
  double maxShear() const { return max_shear_; }
  const IntegrationWork& work() const { return work_; }

 private:
  Local local(double t, const ShotState& at) const { return {p_, t, at, chord_angle_}; }
  void addPoint(double t, const ShotState& at);
  template <typename Inside>
  void addInterval(double t, const Local& from, double dt, const Local& to, const Inside& inside);
  void walkShot(const ShootingSegment& segment);
  void walkQuiet(const ShootingSegment& segment);
  ShotState shootStep(double t, const ShotState& from, double step, double scale);
  double whereSlopeIs(const ShootingSegment& segment, double angle) const;
  std::array<double, 2> whereTailsTurn(const ShootingSegment& segment) const;

  const SegmentedCable& shape_;
  const ShotParameters p_;
  const double span_;
  const int profile_points_;
  std::vector<ProfilePoint>* const profile_;
  const double turns_;  // that the angles stated are less than the nodes' [rad]
  double chord_angle_ = 0.0;
  ShotState state_;
  double stretch_ = 0.0;  // times 1/eps: the integral of the tension
  double sag_ = 0.0;
  double max_moment_ = 0.0;
  double max_shear_ = 0.0;
  IntegrationWork work_;
  StepGrid one_step_ = StepGrid(1);
  Shot shot_;
};

void ShapeWalk::addPoint(double t, const ShotState& at) {
  const Local here = local(t, at);
  // Steps are searched for their extremes by cubics; a point that was asked for is no higher than what is stated.
  sag_ = std::max(sag_, std::abs(here.offset.value));
  max_moment_ = std::max(max_moment_, std::abs(here.moment.value));
  max_shear_ = std::max(max_shear_, std::abs(here.shear.value));
  const ShotCable& unit = shape_.cable;
  profile_->push_back({t * unit.unit_length, at.x * unit.unit_length, at.y * unit.unit_length, at.alpha - turns_,
                       at.moment * unit.unit_moment, here.tension.value * unit.unit_force,
                       -here.shear.value * unit.unit_force});
}

// An interval at whose ends the state is known; inside(t) is the state between.
template <typename Inside>
void ShapeWalk::addInterval(double t, const Local& from, double dt, const Local& to, const Inside& inside) {
  const auto raise = [&](Sample Local::*quantity, double* largest) {
    *largest = std::max({*largest, std::abs((from.*quantity).value), std::abs((to.*quantity).value)});
    const auto at = [&](double where) { return local(where, inside(where)).*quantity; };
    for (const double share : extremesOfCubic(from.*quantity, to.*quantity, dt)) {
      if (!(share > 0.0 && share < 1.0)) continue;
      *largest = std::max(*largest, largestNear({t, from.*quantity}, t + share * dt, {t + dt, to.*quantity}, at));
    }
  };
  raise(&Local::offset, &sag_);
  raise(&Local::moment, &max_moment_);
  raise(&Local::shear, &max_shear_);
  while (static_cast<int>(profile_->size()) < profile_points_ - 1) {
    const double sample = span_ * static_cast<double>(profile_->size()) / (profile_points_ - 1);
    if (sample > t + dt) break;
    addPoint(sample, inside(sample));
  }
}

ShotState ShapeWalk::shootStep(double t, const ShotState& from, double step, double scale) {
  one_step_[0] = step;
  shootOnGrid(p_, t, from, one_step_, scale, &shot_);
  work_ += shot_.work;
  return shot_.end;
}

// A shot's own steps again.
void ShapeWalk::walkShot(const ShootingSegment& segment) {
  double t = segment.begin * span_;
  for (const double recorded : segment.grid) {
    const double dt = shape_.gridScale() * recorded;
    const ShotState next = shootStep(t, state_, recorded, shape_.gridScale());
    const Local from = local(t, state_);
    const Local to = local(t + dt, next);
    // Trapezoids with the correction by the slopes at both ends: of fourth order.
    stretch_ +=
        0.5 * dt * (from.tension.value + to.tension.value) + dt * dt / 12.0 * (from.tension.slope - to.tension.slope);
    addInterval(t, from, dt, to, [&](double sample) { return shootStep(t, state_, sample - t, 1.0); });
    t += dt;
    state_ = next;
  }
}

void ShapeWalk::walkQuiet(const ShootingSegment& segment) {
  const double t = segment.begin * span_;
  const double length = (segment.end - segment.begin) * span_;
  // The tension is that of the catenary but for the square of a small angle.
  stretch_ += catenaryStrainedLength({1.0, 0.0, p_.q}, p_.h, p_.v - p_.q * t, length) - length;
  const ShotState begin = state_;
  const std::array<double, 2> tails = whereTailsTurn(segment);
  for (const double at : {whereSlopeIs(segment, chord_angle_), whereSlopeIs(segment, 0.0), tails[0], tails[1]}) {
    const Local extreme = local(at, shape_.quietStateAt(segment, t, begin, at));
    sag_ = std::max(sag_, std::abs(extreme.offset.value));
    max_moment_ = std::max(max_moment_, std::abs(extreme.moment.value));
  }
  forEachPiece(shape_, segment, begin, [&](double from_t, const ShotState& from, double dt, const ShotState& to) {
    addInterval(from_t, local(from_t, from), dt, local(from_t + dt, to),
                [&](double sample) { return shape_.quietStateAt(segment, from_t, from, sample); });
    state_ = to;
  });
}

// The point of a quiet segment with this slope; its beginning if there is none.
double ShapeWalk::whereSlopeIs(const ShootingSegment& segment, double angle) const {
  const double begin = segment.begin * span_;
  const double end = segment.end * span_;
  double t = (p_.v + p_.h * std::tan(angle)) / p_.q;  // the catenary's
  for (int i = 0; i < kSlopeSteps; ++i) {
    if (!(t > begin && t < end)) return begin;
    const SlowState slow = slowState(p_, t, shape_.mesh.slowOrder());
    const double step = (slow.alpha - angle) / slow.derivative(0, 2);
    t -= step;
    if (std::abs(step) < kSlopeStepShare * span_) break;
  }
  return std::clamp(t, begin, end);
}

// Where what is left of a bending layer's moment balances the rise of the moment without layers: an extreme too slight
// for the cubics.
std::array<double, 2> ShapeWalk::whereTailsTurn(const ShootingSegment& segment) const {
  const double half = 0.5 * (segment.end - segment.begin) * span_;
  const auto distance = [&](const SlowState& slow, double mode, double angle) {
    const double rate = mode * (1.0 + p_.eps * slow.tension);
    const double ratio = -mode * angle * rate / slow.derivative(1, 2);
    return ratio > 1.0 ? std::min(std::log(ratio) / rate, half) : 0.0;
  };
  const SlowState& begin = segment.slow_begin;
  const SlowState& end = segment.slow_end;
  return {segment.begin * span_ + distance(begin, begin.decay, segment.node.x() - begin.alpha),
          segment.end * span_ - distance(end, end.growth, segment.shot.end.alpha - end.alpha)};
}

}  // namespace

double areaBelowChord(const SegmentedCable& shape) {
  const ShotParameters p = shape.cable.parameters();
  const double span = shape.cable.span();
  double area = 0.0;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  // An arc's triangle with A, and what lies between the arc and its chord: a cubic with the slopes at its ends.
  const auto addArc = [&](const Eigen::Vector2d& along, double angle_from, double angle_to) {
    const Eigen::Vector2d to = from + along;
    const double slope = std::atan2(along.y(), along.x());
    area += 0.5 * (from.x() * to.y() - from.y() * to.x()) +
            along.squaredNorm() / 12.0 * (std::sin(angle_to - slope) - std::sin(angle_from - slope));
    from = to;
  };
  for (const ShootingSegment& segment : shape.segments) {
    const ShotState begin = SegmentedCable::beginOf(segment);
    const Eigen::Vector2d along(segment.shot.end.x, segment.shot.end.y);
    if (!segment.quiet) {
      addArc(along, begin.alpha, segment.shot.end.alpha);
    } else if (riseOfForce(p, segment.begin * span, segment.end * span) <= kRiseOfOneArc) {
      addArc(along, segment.slow_begin.alpha, segment.slow_end.alpha);
    } else {
      forEachPiece(shape, segment, begin, [&](double, const ShotState& a, double, const ShotState& b) {
        addArc({b.x - a.x, b.y - a.y}, a.alpha, b.alpha);
      });
    }
  }
  return area * shape.cable.unit_length * shape.cable.unit_length;
}

IntegrationWork measureShape(const SegmentedCable& shape, int profile_points, CableSolution* solution) {
  ShapeWalk walk(shape, profile_points, &solution->profile);
  walk.run();
  const ShotCable& cable = shape.cable;
  solution->x = walk.end().x * cable.unit_length;
  solution->y = walk.end().y * cable.unit_length;
  solution->strained_length = cable.length + cable.parameters().eps * walk.stretch() * cable.unit_length;
  solution->angle_a = shape.segments.front().node.x() - walk.turns();
  solution->angle_b = shape.last_node.x() - walk.turns();
  solution->sag = walk.sag() * cable.unit_length;
  solution->max_moment = walk.maxMoment() * cable.unit_moment;
  solution->max_shear = walk.maxShear() * cable.unit_force;
  return walk.work();
}

}  // namespace cdpr_kinetostatics

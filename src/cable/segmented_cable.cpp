#include "cable/segmented_cable.h"

#include <algorithm>
#include <cmath>

#include "cable/catenary.h"

namespace cdpr_kinetostatics {
namespace {

// Of half the angle by which the layer at a pulley turns: at sqrt(1/2) the rope lifts off, and 1 is the elastica's own.
constexpr double kLargestSine = 0.75;

// cosh(a)/sinh(b) and sinh(a)/sinh(b) for 0 <= a <= b, without overflow.
double coshOverSinh(double a, double b) { return (std::exp(a - b) + std::exp(-a - b)) / -std::expm1(-2.0 * b); }
double sinhOverSinh(double a, double b) { return (std::exp(a - b) - std::exp(-a - b)) / -std::expm1(-2.0 * b); }

// By how much a bending layer turns the cable from its catenary, and takes from its curvature.
struct EndLayer {
  double angle, turn;
};

// The layer that takes so much from the curvature where it begins, s before here; not linearised, (45).
EndLayer pulleyLayer(double turn, double kappa, double s) {
  const double half = std::asin(std::clamp(0.5 * turn / kappa, -kLargestSine, kLargestSine));
  const double angle = 4.0 * std::atan(std::tan(0.5 * half) * std::exp(-kappa * s));
  return {angle, 2.0 * kappa * std::sin(0.5 * angle)};
}

}  // namespace

void SegmentedCable::layOutSegments() {
  const std::vector<MeshInterval>& intervals = mesh.intervals();
  segments.resize(intervals.size());
  for (std::size_t k = 0; k < intervals.size(); ++k) {
    segments[k].begin = intervals[k].begin;
    segments[k].end = intervals[k].end;
    segments[k].quiet = intervals[k].quiet;
    segments[k].grid.clear();
  }
}

void SegmentedCable::startOnCatenary() {
  const CableProperties& properties = cable.properties;
  const double length = cable.length;
  const double h = cable.force.x();
  const double v = cable.force.y();
  const auto tension = [&](double s) { return std::hypot(h, properties.weight * s - v); };
  const auto turning = [&](double s) { return properties.weight * h / std::pow(tension(s), 2); };
  const auto layers = [&](double s) { return std::sqrt(tension(s) / properties.bending_stiffness); };
  const double kappa_a = layers(0.0);
  const double kappa_b = layers(length);
  const double turn_a = turning(0.0);
  const double turn_b = turning(length);
  const bool pulley = hasPulley(properties);
  const double turn_on_pulley = momentAtDeparture(properties) / properties.bending_stiffness;
  const auto nodeAt = [&](double s) {
    const double to_b = length - s;
    const EndLayer layer = pulley ? pulleyLayer(turn_a - turn_on_pulley, kappa_a, s)
                                  : EndLayer{turn_a / kappa_a * coshOverSinh(kappa_a * to_b, kappa_a * length),
                                             turn_a * sinhOverSinh(kappa_a * to_b, kappa_a * length)};
    const double angle = catenaryAngle(properties, h, v, s) + layer.angle -
                         turn_b / kappa_b * coshOverSinh(kappa_b * s, kappa_b * length);
    const double turn = turning(s) - layer.turn - turn_b * sinhOverSinh(kappa_b * s, kappa_b * length);
    return Eigen::Vector2d(angle, turn * cable.unit_length);
  };
  for (ShootingSegment& segment : segments) segment.node = nodeAt(segment.begin * length);
  last_node = nodeAt(length);
  segments.front().node.y() = cable.momentAtA();
  last_node.y() = 0.0;
}

void SegmentedCable::evaluateQuietEnds(std::size_t k) {
  ShootingSegment& segment = segments[k];
  segment.slow_begin = slowState(cable.parameters(), segment.begin * cable.span(), mesh.slowOrder());
  segment.slow_end = slowState(cable.parameters(), segment.end * cable.span(), mesh.slowOrder());
  segment.shot.end.alpha = node(k + 1).x();
  segment.shot.end.moment = node(k + 1).y();
}

void SegmentedCable::evaluateAllQuietEnds() {
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (segments[k].quiet) evaluateQuietEnds(k);
  }
}

void SegmentedCable::evaluateQuietSegment(std::size_t k) {
  evaluateQuietEnds(k);
  ShootingSegment& segment = segments[k];
  const double span = cable.span();
  segment.slow_stretch = slowStretch(cable.parameters(), segment.begin * span, segment.end * span, mesh.slowOrder());
  const Eigen::Vector2d along = segment.slow_stretch.displacement +
                                segment.slow_begin.ahead * (segment.node.x() - segment.slow_begin.alpha) +
                                segment.slow_end.behind * (segment.shot.end.alpha - segment.slow_end.alpha);
  segment.shot.end.x = along.x();
  segment.shot.end.y = along.y();
}

ShotState SegmentedCable::quietStateAt(const ShootingSegment& segment, double t_from, const ShotState& from,
                                       double t) const {
  const ShotParameters p = cable.parameters();
  const double span = cable.span();
  const SlowState& begin = segment.slow_begin;
  const SlowState& end = segment.slow_end;
  const SlowState slow = slowState(p, t, mesh.slowOrder());
  const double from_begin = segment.node.x() - begin.alpha;
  const double from_end = segment.shot.end.alpha - end.alpha;
  const auto ahead = [&](double at) {
    return from_begin * std::exp(-begin.decay * (1.0 + p.eps * begin.tension) * (at - segment.begin * span));
  };
  const auto behind = [&](double at) {
    return from_end * std::exp(-end.growth * (1.0 + p.eps * end.tension) * (segment.end * span - at));
  };
  const Eigen::Vector2d along = slowStretch(p, t_from, t, mesh.slowOrder()).displacement +
                                begin.ahead * (ahead(t_from) - ahead(t)) + end.behind * (behind(t) - behind(t_from));
  return {slow.alpha + ahead(t) + behind(t), slow.moment - slow.decay * ahead(t) + slow.growth * behind(t),
          from.x + along.x(), from.y + along.y()};
}

Eigen::Vector2d SegmentedCable::stateAt(double share) const {
  std::size_t k = 0;
  while (k + 1 < segments.size() && segments[k].end <= share) ++k;
  const ShootingSegment& segment = segments[k];
  const ShotParameters p = cable.parameters();
  const double span = cable.span();
  const ShotState a = beginOf(segment);
  if (segment.quiet) {
    const ShotState at = quietStateAt(segment, segment.begin * span, a, share * span);
    return {at.alpha, at.moment};
  }
  const double width = (segment.end - segment.begin) * span;
  const ShotState b{node(k + 1).x(), node(k + 1).y(), 0.0, 0.0};
  const ShotState da = shotDerivative(p, segment.begin * span, a);
  const ShotState db = shotDerivative(p, segment.end * span, b);
  const double u = (share - segment.begin) / (segment.end - segment.begin);
  const auto cubic = [&](double from, double from_slope, double to, double to_slope) {
    const double rise = to - from;
    return from + u * rise + u * (1.0 - u) * ((1.0 - u) * (width * from_slope - rise) - u * (width * to_slope - rise));
  };
  return {cubic(a.alpha, da.alpha, b.alpha, db.alpha), cubic(a.moment, da.moment, b.moment, db.moment)};
}

}  // namespace cdpr_kinetostatics

// The mesh of a cable that is many layers long and bends too sharply somewhere for a quiet middle: the two ends and the
// bend are shot, the legs between them are quiet.
#include <algorithm>
#include <array>
#include <cmath>

#include "cable/mesh_rules.h"
#include "cable/multiple_shooting.h"

namespace cdpr_kinetostatics {
namespace {

// A leg keeps this far away from the bend: sigma = q^2/T^3 (slow_manifold.h) at its end, halved until the series is
// accurate there, with some room for the forces to change.
constexpr double kLargestSigma = 0.02;
constexpr int kHalvings = 12;
constexpr double kRoom = 0.2;  // of the error

// The layers of an end before a leg, at least.
constexpr double kFewestLayersAtEnd = 8.0;

struct Leg {
  double begin = 0.0;
  double end = 0.0;
  int order = 0;  // 0: there is none
};

// From one end's layers to the bend or, on the other side of it, back.
Leg quietLeg(const ShotParameters& p, double begin, double end, double bend, double error) {
  const bool before_bend = begin + end < 2.0 * bend;
  double sigma = kLargestSigma;
  for (int i = 0; i < kHalvings; ++i, sigma *= 0.5) {
    const double tension = std::cbrt(p.q * p.q / sigma);
    const double away = std::sqrt(std::max(0.0, tension * tension - p.h * p.h)) / p.q;
    Leg leg{before_bend ? begin : std::max(begin, bend + away), before_bend ? std::min(end, bend - away) : end, 0};
    if (!((leg.end - leg.begin) * layerRate(p, 0.5 * (leg.begin + leg.end)) > kShortestMiddle)) return leg;
    leg.order = slowOrder(p, leg.begin, leg.end, kRoom * error);
    if (leg.order > 0) return leg;
  }
  return {};
}

double layersBetween(const ShotParameters& p, double from, double to) {
  return (to - from) / 6.0 * (layerRate(p, from) + 4.0 * layerRate(p, 0.5 * (from + to)) + layerRate(p, to));
}

}  // namespace

bool MultipleShooting::placeAroundBend() {
  const ShotParameters p = parameters();
  if (p.q == 0.0) return false;
  const double span = length_ / reference_length_;
  const double error = kMiddleShare * shot_tolerance_.alpha;
  const auto endLayer = [&](double end, double inwards) {
    const double layers = std::max(kFewestLayersAtEnd, layersNeeded(p, end, span, error));
    return end + inwards * layers / layerRate(p, end + 0.5 * inwards * layers / layerRate(p, end));
  };
  const double a = endLayer(0.0, 1.0);
  const double b = endLayer(span, -1.0);
  const double bend = p.v / p.q;
  const Leg first = a < std::min(bend, b) ? quietLeg(p, a, std::min(bend, b), bend, error) : Leg{};
  const Leg second = b > std::max(bend, a) ? quietLeg(p, std::max(bend, a), b, bend, error) : Leg{};
  if (first.order == 0 && second.order == 0) return false;

  shot_bend_ = true;
  slow_order_ = std::max(first.order, second.order);
  setSegmentCount(0);
  double reached = 0.0;
  for (const Leg& leg : {first, second}) {
    if (leg.order == 0) continue;
    shootBetween(reached, leg.begin);
    appendSegment(leg.begin / span, leg.end / span, true);
    reached = leg.end;
  }
  shootBetween(reached, span);
  return true;
}

void MultipleShooting::appendSegment(double begin, double end, bool quiet) {
  setSegmentCount(segments_.size() + 1);
  Segment& segment = segments_.back();
  segment.quiet = quiet;
  segment.begin = begin;
  segment.end = end;
  segment.grid.clear();
}

// Appends shots that end where the integral of (local layers, turning angle) reaches equal shares.
void MultipleShooting::shootBetween(double t_from, double t_to) {
  constexpr int kSamples = 64;
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  const double h = std::max(p.h, std::cbrt(p.q * p.q));  // bending rounds a loop off
  const auto angle = [&](double t) { return std::atan2(p.q * t - p.v, h); };
  const double dt = (t_to - t_from) / kSamples;
  std::array<double, kSamples + 1> share{};
  for (int i = 0; i < kSamples; ++i) {
    const double t = t_from + i * dt;
    share[i + 1] =
        share[i] + layersBetween(p, t, t + dt) / kLayersPerSegment + (angle(t + dt) - angle(t)) / kAnglePerSegment;
  }
  const int count = static_cast<int>(std::clamp(std::ceil(share[kSamples]), 1.0, kMaxSegments + 1.0));
  int sample = 1;
  double begin = t_from;
  for (int k = 1; k <= count; ++k) {
    const double target = share[kSamples] * k / count;
    while (sample < kSamples && share[sample] < target) ++sample;
    const double inside = (target - share[sample - 1]) / (share[sample] - share[sample - 1]);
    const double end = k == count ? t_to : t_from + (sample - 1 + inside) * dt;
    appendSegment(begin / span, end == span ? 1.0 : end / span, false);
    begin = end;
  }
}

bool MultipleShooting::bendFits() {
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  const double error = kMiddleShare * shot_tolerance_.alpha;
  int order = 0;
  for (const Segment& segment : segments_) {
    const double from = segment.begin * span;
    const double to = segment.end * span;
    if (!segment.quiet) {
      if (layersBetween(p, from, to) > kMostLayersPerSegment) return false;
      continue;
    }
    const int here = slowOrder(p, from, to, error);
    if (here == 0) return false;
    order = std::max(order, here);
  }
  slow_order_ = order;
  const auto longEnough = [&](double end, double layer) {
    return layersBetween(p, std::min(end, layer), std::max(end, layer)) >=
           kShortLayer * layersNeeded(p, end, span, error);
  };
  const auto quiet = [](const Segment& segment) { return segment.quiet; };
  const auto first = std::find_if(segments_.begin(), segments_.end(), quiet);
  const auto last = std::find_if(segments_.rbegin(), segments_.rend(), quiet);
  return longEnough(0.0, first->begin * span) && longEnough(span, last->end * span);
}

void MultipleShooting::keepShape(const MultipleShooting& before) {
  for (Segment& segment : segments_) segment.node = before.stateAt(segment.begin);
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    if (segments_[k].quiet) evaluateModes(k);
  }
}

// (alpha, moment) between nodes: the cubics through shots' ends, the slow solution and its modes elsewhere.
Eigen::Vector2d MultipleShooting::stateAt(double share) const {
  std::size_t k = 0;
  while (k + 1 < segments_.size() && segments_[k].end <= share) ++k;
  const Segment& segment = segments_[k];
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  const ShotState a{segment.node.x(), segment.node.y(), 0.0, 0.0};
  if (segment.quiet) {
    const ShotState at = middleState(segment, segment.begin * span, a, share * span);
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

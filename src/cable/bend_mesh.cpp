#include "cable/bend_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cable/mesh_rules.h"
#include "cable/slow_manifold.h"

namespace cdpr_kinetostatics {
namespace {

// A leg keeps so far away from the bend that sigma = q^2/T^3 (slow_manifold.h) at its end is at most this, and then
// halves it until the series is accurate there. At 0.02 the second term of the series is about 0.2 of the first; after
// twelve halvings it is 1e-4 of it, and no tolerance asks for less.
constexpr double kLargestSigma = 0.02;
constexpr int kHalvings = 12;

// A new leg has this share of the error that it may have, so that the forces can change before the mesh has to.
constexpr double kErrorOfNewLeg = 0.2;

// Layers between an end of the cable and a leg, at least: the forces of a loop change much before it is found.
constexpr double kFewestLayersAtEnd = 8.0;

// Pieces in which the layers and the angle of a stretch are summed up, by Simpson's rule.
constexpr std::size_t kPieces = 64;

struct Leg {
  double begin = 0.0;
  double end = 0.0;
  int order = 0;  // 0: there is none
};

// The quiet part of the cable between the layers of one end and the bend or, on the other side of the bend, between it
// and the layers of the other end.
Leg quietLeg(const ShotParameters& p, double begin, double end, double bend, double error) {
  const bool before_bend = begin + end < 2.0 * bend;
  double sigma = kLargestSigma;
  for (int i = 0; i < kHalvings; ++i, sigma *= 0.5) {
    const double tension = std::cbrt(p.q * p.q / sigma);
    const double away = std::sqrt(std::max(0.0, tension * tension - p.h * p.h)) / p.q;
    Leg leg{before_bend ? begin : std::max(begin, bend + away), before_bend ? std::min(end, bend - away) : end, 0};
    if (!((leg.end - leg.begin) * layerRate(p, 0.5 * (leg.begin + leg.end)) > kShortestMiddle)) return leg;
    leg.order = slowOrder(p, leg.begin, leg.end, kErrorOfNewLeg * error);
    if (leg.order > 0) return leg;
  }
  return {};
}

// Simpson's rule.
double layersBetween(const ShotParameters& p, double from, double to) {
  return (to - from) / 6.0 * (layerRate(p, from) + 4.0 * layerRate(p, 0.5 * (from + to)) + layerRate(p, to));
}

void shootBetween(const ShotParameters& p, double span, double from, double to, std::vector<MeshInterval>* intervals) {
  // The angle is that of the force, but for a loop, whose bending stiffness rounds the bend off to the radius at which
  // q^2 = T^3.
  const double h = std::max(p.h, std::cbrt(p.q * p.q));
  const auto angle = [&](double t) { return std::atan2(p.q * t - p.v, h); };
  const double dt = (to - from) / kPieces;
  std::array<double, kPieces + 1> share{};
  for (std::size_t i = 0; i < kPieces; ++i) {
    const double t = from + static_cast<double>(i) * dt;
    share[i + 1] =
        share[i] + layersBetween(p, t, t + dt) / kLayersPerSegment + (angle(t + dt) - angle(t)) / kAnglePerSegment;
  }
  double begin = from;
  cutAtEqualShares(share, 1, [&](double u) {
    const double end = u == 1.0 ? to : from + u * (to - from);
    intervals->push_back({begin / span, end == span ? 1.0 : end / span, false});
    begin = end;
  });
}

}  // namespace

int placeAroundBend(const ShotCable& cable, double error, std::vector<MeshInterval>* intervals) {
  const ShotParameters p = cable.parameters();
  if (p.q == 0.0) return 0;
  const double span = cable.span();
  const auto endLayer = [&](double end, double inwards, double moment) {
    const double layers = std::max(kFewestLayersAtEnd, layersNeeded(p, end, span, error, moment));
    return end + inwards * layers / layerRate(p, end + 0.5 * inwards * layers / layerRate(p, end));
  };
  const double a = endLayer(0.0, 1.0, cable.momentAtA());
  const double b = endLayer(span, -1.0, 0.0);
  const double bend = p.v / p.q;
  const Leg first = a < std::min(bend, b) ? quietLeg(p, a, std::min(bend, b), bend, error) : Leg{};
  const Leg second = b > std::max(bend, a) ? quietLeg(p, std::max(bend, a), b, bend, error) : Leg{};
  if (first.order == 0 && second.order == 0) return 0;

  double reached = 0.0;
  for (const Leg& leg : {first, second}) {
    if (leg.order == 0) continue;
    shootBetween(p, span, reached, leg.begin, intervals);
    intervals->push_back({leg.begin / span, leg.end / span, true});
    reached = leg.end;
  }
  shootBetween(p, span, reached, span, intervals);
  return std::max(first.order, second.order);
}

int bendOrder(const std::vector<MeshInterval>& intervals, const ShotCable& cable, double error) {
  const ShotParameters p = cable.parameters();
  const double span = cable.span();
  int order = 0;
  for (const MeshInterval& interval : intervals) {
    const double from = interval.begin * span;
    const double to = interval.end * span;
    if (!interval.quiet) {
      if (layersBetween(p, from, to) > kMostLayersPerSegment) return 0;
      continue;
    }
    const int here = slowOrder(p, from, to, error);
    if (here == 0) return 0;
    order = std::max(order, here);
  }
  const auto longEnough = [&](double end, double layer, double moment) {
    return layersBetween(p, std::min(end, layer), std::max(end, layer)) >=
           kShortLayer * layersNeeded(p, end, span, error, moment);
  };
  const auto quiet = [](const MeshInterval& interval) { return interval.quiet; };
  const auto first = std::find_if(intervals.begin(), intervals.end(), quiet);
  const auto last = std::find_if(intervals.rbegin(), intervals.rend(), quiet);
  return longEnough(0.0, first->begin * span, cable.momentAtA()) && longEnough(span, last->end * span, 0.0) ? order : 0;
}

}  // namespace cdpr_kinetostatics

// What the meshes of the bending cable have in common.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "cable/bounded_count.h"
#include "cable/shot.h"

namespace cdpr_kinetostatics {

// A shot segment spans at most this many local bending layers, and this much of the catenary's turning angle: Newton's
// method starts to fail beyond about 4 layers. A mesh is kept while the forces have not shortened its layers so far
// that a segment spans more than kMostLayersPerSegment.
inline constexpr double kLayersPerSegment = 3.0;
inline constexpr double kMostLayersPerSegment = 4.2;
inline constexpr double kAnglePerSegment = 1.0;  // [rad]

// Cables that would need more segments are refused. This many hold 3000 bending layers, all of which would have to be
// shot: neither the ends nor the bend leave a quiet interval. Such a cable differs from its catenary by some 1e-7 of
// its length, and a pass over it would take a hundred times as long as one over a usual cable.
inline constexpr int kMaxSegments = 1000;

// The quiet middle begins where so many layers have made the modes of the end too small to matter: the logarithm of
// their effect, and one layer to spare for forces that change. 24 layers reduce a mode to 4e-11 of what it was, which
// the finest tolerances do not see. A middle that is shorter than four segments is not worth its own errors.
inline constexpr double kSpareLayers = 1.0;
inline constexpr double kMostLayersAtEnd = 24.0;
inline constexpr double kShortestMiddle = 12.0;  // [layers]

// The mesh is placed anew where changed forces have shortened a layer to less than this share of what it should span.
inline constexpr double kShortLayer = 0.8;

// Layers per unit of t.
inline double layerRate(const ShotParameters& p, double t) { return std::sqrt(std::hypot(p.h, p.q * t - p.v)); }

// Layers at the end t before a mode that it raises moves the cable's far end by less than the error [rad] of
// alpha times the cable's length, second-order effects of the mode included (slow_manifold.h has the first).
// None where even the whole mode does not. `moment` is what the end is held by: the mode has to bring the cable to it.
inline double layersNeeded(const ShotParameters& p, double t, double span, double error, double moment) {
  const double rate = layerRate(p, t);
  // Layer thickness over radius of curvature.
  const double bend = p.q * p.h / std::pow(rate, 5) + std::abs(moment) / rate;
  const double effect = bend * bend / (rate * span * error);
  return std::clamp(effect > 0.0 ? kSpareLayers + std::log(effect) : 0.0, 0.0, kMostLayersAtEnd);
}

// Segments of equal shares of bending layers and turning angle. share[i] is the number of segments that the first i of
// equally long pieces of a stretch ask for, from share[0] = 0 to all of it. Calls append(u) for the end of each segment
// in turn, u from 0 to 1 along the stretch; at least `fewest` segments.
template <std::size_t kSize, typename Append>
void cutAtEqualShares(const std::array<double, kSize>& share, int fewest, const Append& append) {
  constexpr std::size_t kPieces = kSize - 1;
  const int count = boundedCount(share[kPieces], fewest, kMaxSegments + 1);
  std::size_t piece = 1;
  for (int k = 1; k < count; ++k) {
    const double target = share[kPieces] * k / count;
    while (piece < kPieces && share[piece] < target) ++piece;
    const double width = share[piece] - share[piece - 1];
    const double inside = width > 0.0 ? (target - share[piece - 1]) / width : 1.0;
    append((static_cast<double>(piece - 1) + inside) / kPieces);
  }
  append(1.0);
}

}  // namespace cdpr_kinetostatics

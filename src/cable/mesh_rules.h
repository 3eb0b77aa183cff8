// What the meshes of the bending cable have in common.
#pragma once

#include <algorithm>
#include <cmath>

#include "cable/shot.h"

namespace cdpr_kinetostatics {

// A segment spans at most this many local bending layers, and this much of the catenary's turning angle:
// beyond about 4 layers Newton's method starts to fail.
inline constexpr double kLayersPerSegment = 3.0;
inline constexpr double kMostLayersPerSegment = 4.2;  // where forces have changed since
inline constexpr double kAnglePerSegment = 1.0;       // [rad]

// The quiet middle begins where so many layers have made the modes of the end too small to matter. A middle shorter
// than a few segments is not worth its own errors.
inline constexpr double kMiddleShare = 0.1;  // of the error [rad] that one integration step may make
inline constexpr double kSpareLayers = 1.0;
inline constexpr double kMostLayersAtEnd = 24.0;
inline constexpr double kShortestMiddle = 12.0;  // [layers]

// A layer that forces have shortened to less than this share of what it should span is replaced.
inline constexpr double kShortLayer = 0.8;

// Layers per unit of t.
inline double layerRate(const ShotParameters& p, double t) { return std::sqrt(std::hypot(p.h, p.q * t - p.v)); }

// Layers at the end t before a mode that it raises moves the cable's far end by less than the error [rad] of
// alpha times the cable's length, second-order effects of the mode included (slow_manifold.h has the first).
// None where even the whole mode does not.
inline double layersNeeded(const ShotParameters& p, double t, double span, double error) {
  const double rate = layerRate(p, t);
  const double bend = p.q * p.h / std::pow(rate, 5);  // layer thickness over radius of curvature
  const double effect = bend * bend / (rate * span * error);
  return std::clamp(effect > 0.0 ? kSpareLayers + std::log(effect) : 0.0, 0.0, kMostLayersAtEnd);
}

}  // namespace cdpr_kinetostatics

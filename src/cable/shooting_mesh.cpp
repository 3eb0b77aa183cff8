#include "cable/shooting_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cable/bend_mesh.h"
#include "cable/bounded_count.h"
#include "cable/catenary.h"
#include "cable/mesh_rules.h"
#include "cable/slow_manifold.h"

namespace cdpr_kinetostatics {
namespace {

// Pieces in which the layers and the angle of a whole cable are summed up. A segment's ends need no more accuracy than
// this gives: Newton's method joins segments of any length.
constexpr std::size_t kPieces = 128;

// The shots at one end of the cable before the quiet middle.
struct EndShots {
  static constexpr int kMost = static_cast<int>(kMostLayersAtEnd / kLayersPerSegment) + 1;
  std::array<double, kMost + 1> t{};  // from the end of the cable inwards
  int count = 0;

  double inner() const { return t[count]; }
};

// inwards: the direction of t into the cable, 1 at A and -1 at B.
EndShots shotsAtEnd(const ShotParameters& p, double end, double inwards, double span, double error, double moment) {
  EndShots shots;
  const double layers = layersNeeded(p, end, span, error, moment);
  shots.count = boundedCount(layers / kLayersPerSegment, 0, EndShots::kMost);
  const double share = inwards * layers / shots.count;
  shots.t[0] = end;
  for (int i = 0; i < shots.count; ++i) {
    const double middle = shots.t[i] + 0.5 * share / layerRate(p, shots.t[i]);
    shots.t[i + 1] = shots.t[i] + share / layerRate(p, middle);
  }
  return shots;
}

// Terms of the series in the one quiet middle of this mesh; 0 if the mesh no longer fits.
int middleOrder(const std::vector<MeshInterval>& intervals, const ShotCable& cable, double error) {
  const ShotParameters p = cable.parameters();
  const double span = cable.span();
  std::size_t middle = 0;
  while (!intervals[middle].quiet) ++middle;
  const double begin = intervals[middle].begin * span;
  const double end = intervals[middle].end * span;
  const auto fits = [&](double at_end, double layer, std::size_t count, double moment) {
    const double layers = layer * layerRate(p, std::abs(at_end - 0.5 * layer));
    return layers >= kShortLayer * layersNeeded(p, at_end, span, error, moment) &&
           layers <= kMostLayersPerSegment * static_cast<double>(count);
  };
  return fits(0.0, begin, middle, cable.momentAtA()) && fits(span, span - end, intervals.size() - 1 - middle, 0.0)
             ? slowOrder(p, begin, end, error)
             : 0;
}

}  // namespace

void ShootingMesh::place(const ShotCable& cable, const ShootingAccuracy& accuracy, Middle middle) {
  intervals_.clear();
  slow_order_ = 0;
  shot_bend_ = false;
  if (middle == Middle::kQuiet) {
    if (placeAroundMiddle(cable, accuracy.ofQuietInterval())) return;
    slow_order_ = placeAroundBend(cable, accuracy.ofQuietInterval(), &intervals_);
    shot_bend_ = slow_order_ > 0;
    if (shot_bend_) return;
  }
  placeEverywhere(cable, accuracy.fewestShots());
}

bool ShootingMesh::placeAroundMiddle(const ShotCable& cable, double error) {
  const ShotParameters p = cable.parameters();
  const double span = cable.span();
  if (!hasQuietForce(p, 0.0, span)) return false;
  const EndShots a = shotsAtEnd(p, 0.0, 1.0, span, error, cable.momentAtA());
  const EndShots b = shotsAtEnd(p, span, -1.0, span, error, 0.0);
  const double begin = a.inner();
  const double end = b.inner();
  if (!((end - begin) * layerRate(p, 0.5 * (begin + end)) > kShortestMiddle)) return false;
  slow_order_ = cdpr_kinetostatics::slowOrder(p, begin, end, error);
  if (slow_order_ == 0) return false;

  for (int i = 0; i < a.count; ++i) intervals_.push_back({a.t[i] / span, a.t[i + 1] / span, false});
  intervals_.push_back({begin / span, end / span, true});
  for (int i = b.count; i > 0; --i) intervals_.push_back({b.t[i] / span, b.t[i - 1] / span, false});
  return true;
}

// In SI units, since the catenary is.
void ShootingMesh::placeEverywhere(const ShotCable& cable, int fewest) {
  const double h = cable.force.x();
  const double v = cable.force.y();
  const double angle_a = catenaryAngle(cable.properties, h, v, 0.0);
  const double ds = cable.length / kPieces;
  std::array<double, kPieces + 1> share{};
  double layers = 0.0;
  for (std::size_t i = 1; i <= kPieces; ++i) {
    const double t_middle = std::hypot(h, cable.properties.weight * (static_cast<double>(i) - 0.5) * ds - v);
    layers += std::sqrt(t_middle / cable.properties.bending_stiffness) * ds;
    const double angle = catenaryAngle(cable.properties, h, v, static_cast<double>(i) * ds);
    share[i] = layers / kLayersPerSegment + std::abs(angle - angle_a) / kAnglePerSegment;
  }
  double begin = 0.0;
  cutAtEqualShares(share, fewest, [&](double end) {
    intervals_.push_back({begin, end, false});
    begin = end;
  });
}

bool ShootingMesh::fits(const ShotCable& cable, const ShootingAccuracy& accuracy) {
  if (!hasQuietMiddle()) return true;
  const int order = orderThatFits(cable, accuracy.ofQuietInterval());
  if (order == 0) return false;
  slow_order_ = order;
  return true;
}

int ShootingMesh::orderThatFits(const ShotCable& cable, double error) const {
  return hasShotBend() ? bendOrder(intervals_, cable, error) : middleOrder(intervals_, cable, error);
}

}  // namespace cdpr_kinetostatics

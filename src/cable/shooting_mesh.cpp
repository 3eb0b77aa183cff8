// Where the segments of a bending cable begin and end, and what their nodes start from.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cable/catenary.h"
#include "cable/mesh_rules.h"
#include "cable/multiple_shooting.h"

namespace cdpr_kinetostatics {
namespace {

// Share of the tolerance that one integration step may use up.
constexpr double kStepShare = 0.1;

// Integration steps that a segment has room for at once.
constexpr std::size_t kUsualSteps = 64;

// Below this share of the tolerance of angles the cable counts as ruled by its stretch.
constexpr double kStretchRules = 0.1;
constexpr double kSeveral = 16.0;

// cosh(a)/sinh(b) and sinh(a)/sinh(b) for 0 <= a <= b, without overflow.
double coshOverSinh(double a, double b) { return (std::exp(a - b) + std::exp(-a - b)) / -std::expm1(-2.0 * b); }
double sinhOverSinh(double a, double b) { return (std::exp(a - b) - std::exp(-a - b)) / -std::expm1(-2.0 * b); }

// The error of alpha that matters, over the tolerance. An error of alpha moves the end by that times the angle that the
// cable turns. What this does to the forces depends on how the cable gives way: by its sag, which is as large as the
// turn, or, if its bending stiffness keeps it straight, by its stretch alone.
double angleScale(const CableProperties& cable, double length, double force, double turned) {
  const double beam_turn = cable.weight * length * length * length / (24.0 * cable.bending_stiffness);
  const double by_stretch = beam_turn < turned ? force / (cable.axial_stiffness * beam_turn) : turned;
  return std::clamp(std::min(turned, by_stretch), 1e-6, 1.0);
}

}  // namespace

void MultipleShooting::begin(const CableProperties& cable, double length, const Eigen::Vector2d& force,
                             double tolerance, double angle_scale, Middle middle) {
  cable_ = cable;
  tolerance_ = tolerance;
  length_ = length;
  grid_length_ = length;
  force_ = force;
  shot_tolerance_.alpha = shot_tolerance_.moment = kStepShare * tolerance_ * angle_scale;
  setReference();
  placeSegments(middle);
}

void MultipleShooting::start(const CableProperties& cable, double length, double horizontal_force,
                             double vertical_force_a, double tolerance, Middle middle) {
  const double turned = std::abs(catenaryAngle(cable, horizontal_force, vertical_force_a, length) -
                                 catenaryAngle(cable, horizontal_force, vertical_force_a, 0.0));
  const double force = std::hypot(horizontal_force, vertical_force_a);
  begin(cable, length, {horizontal_force, vertical_force_a}, tolerance, angleScale(cable, length, force, turned),
        middle);
  startNodes();
}

void MultipleShooting::startStraight(const CableProperties& cable, double length, double x, double y,
                                     double tolerance) {
  const double chord = std::hypot(x, y);
  const double tension = cable.axial_stiffness * (chord / length - 1.0);
  begin(cable, length, {tension * x / chord, 0.5 * cable.weight * length - tension * y / chord}, tolerance,
        angleScale(cable, length, std::abs(tension), 1.0), Middle::kShot);
  for (Segment& segment : segments_) segment.node << std::atan2(y, x), 0.0;
  last_node_ << std::atan2(y, x), 0.0;
}

void MultipleShooting::changeProperties(const CableProperties& cable) {
  if (hasQuietMiddle() && !hasShotBend()) replaceMesh(Middle::kShot);
  const double before = reference_length_;
  cable_ = cable;
  setReference();
  for (Segment& segment : segments_) {
    segment.node.y() *= reference_length_ / before;
    segment.grid.clear();
  }
  shot_tolerance_.alpha = shot_tolerance_.moment = kStepShare * tolerance_;
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    if (segments_[k].quiet) evaluateModes(k);
  }
}

std::optional<double> MultipleShooting::startFromAngle(const CableProperties& cable, double length,
                                                       double horizontal_force, double vertical_force_a, double angle,
                                                       double tolerance) {
  begin(cable, length, {horizontal_force, vertical_force_a}, tolerance, 1.0, Middle::kShot);
  const double span = length_ / reference_length_;
  ShotState state{angle, 0.0, 0.0, 0.0};
  for (Segment& segment : segments_) {
    segment.node << state.alpha, state.moment;
    const bool shot = shootAdaptive(parameters(), segment.begin * span, segment.end * span, state, shot_tolerance_,
                                    &segment.grid, &segment.shot);
    work_ += segment.shot.work;
    if (!shot) return std::nullopt;
    state = {segment.shot.end.alpha, segment.shot.end.moment, 0.0, 0.0};
  }
  last_node_ << state.alpha, 0.0;
  return state.moment;
}

void MultipleShooting::placeSegments(Middle middle) {
  slow_order_ = 0;
  shot_bend_ = false;
  if (middle == Middle::kShot || !(placeAroundMiddle() || placeAroundBend())) placeEverywhere();
}

// Segments that fall away are kept with their buffers, so that a mesh that changes takes nothing from the heap.
void MultipleShooting::setSegmentCount(std::size_t count) {
  while (segments_.size() > count) {
    spare_segments_.push_back(std::move(segments_.back()));
    segments_.pop_back();
  }
  while (segments_.size() < count) {
    if (spare_segments_.empty()) {
      Segment& segment = spare_segments_.emplace_back();
      segment.grid.reserve(kUsualSteps);
      segment.shot.turning.reserve(kUsualSteps);
    }
    segments_.push_back(std::move(spare_segments_.back()));
    spare_segments_.pop_back();
  }
}

bool MultipleShooting::placeAroundMiddle() {
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  if (!hasQuietForce(p, 0.0, span)) return false;
  constexpr int kMost = static_cast<int>(kMostLayersAtEnd / kLayersPerSegment) + 1;
  struct Layer {
    std::array<double, kMost + 1> t{};  // from the end of the cable inwards
    int count = 0;
  };
  const auto layer = [&](double end, double inwards) {
    Layer result;
    const double layers = layersNeeded(p, end, span, kMiddleShare * shot_tolerance_.alpha);
    result.count = static_cast<int>(std::ceil(layers / kLayersPerSegment));
    const double share = inwards * layers / result.count;
    result.t[0] = end;
    for (int i = 0; i < result.count; ++i) {
      const double middle = result.t[i] + 0.5 * share / layerRate(p, result.t[i]);
      result.t[i + 1] = result.t[i] + share / layerRate(p, middle);
    }
    return result;
  };
  const Layer a = layer(0.0, 1.0);
  const Layer b = layer(span, -1.0);
  const double begin = a.t[a.count];
  const double end = b.t[b.count];
  if (!((end - begin) * layerRate(p, 0.5 * (begin + end)) > kShortestMiddle)) return false;
  const int order = slowOrder(p, begin, end, kMiddleShare * shot_tolerance_.alpha);
  if (order == 0) return false;

  slow_order_ = order;
  setSegmentCount(a.count + 1 + b.count);
  const auto place = [&](int k, double from, double to, bool quiet) {
    segments_[k].quiet = quiet;
    segments_[k].begin = from / span;
    segments_[k].end = to / span;
    segments_[k].grid.clear();
  };
  for (int i = 0; i < a.count; ++i) place(i, a.t[i], a.t[i + 1], false);
  place(a.count, begin, end, true);
  for (int i = 0; i < b.count; ++i) place(a.count + 1 + i, b.t[b.count - i], b.t[b.count - i - 1], false);
  return true;
}

// Segments end where the integral of (local layers, turning angle) reaches equal shares.
void MultipleShooting::placeEverywhere() {
  constexpr int kSamples = 128;
  const double h = force_.x();
  const double angle_a = catenaryAngle(cable_, h, force_.y(), 0.0);
  const double ds = length_ / kSamples;
  std::array<double, kSamples + 1> share{};
  double layers = 0.0;
  for (int i = 1; i <= kSamples; ++i) {
    const double t_middle = std::hypot(h, cable_.weight * (i - 0.5) * ds - force_.y());
    layers += std::sqrt(t_middle / cable_.bending_stiffness) * ds;
    share[i] = layers / kLayersPerSegment +
               std::abs(catenaryAngle(cable_, h, force_.y(), i * ds) - angle_a) / kAnglePerSegment;
  }
  // Where stretch rules the forces, the error of x and y matters, which no step control looks at: several steps at
  // least.
  const double fewest = shot_tolerance_.alpha < kStretchRules * kStepShare * tolerance_ ? kSeveral : 1.0;
  const int count = static_cast<int>(std::clamp(std::ceil(share[kSamples]), fewest, kMaxSegments + 1.0));
  setSegmentCount(count);
  int sample = 1;
  double begin = 0.0;
  for (int k = 0; k < count; ++k) {
    const double target = share[kSamples] * (k + 1) / count;
    while (sample < kSamples && share[sample] < target) ++sample;
    const double width = share[sample] - share[sample - 1];
    const double inside = width > 0.0 ? (target - share[sample - 1]) / width : 1.0;
    const double end = k == count - 1 ? 1.0 : (sample - 1 + inside) / kSamples;
    segments_[k].quiet = false;
    segments_[k].begin = begin;
    segments_[k].end = end;
    segments_[k].grid.clear();
    begin = end;
  }
}

// Catenary plus the bending layers of its two ends, which bring the moment to zero there.
void MultipleShooting::startNodes() {
  const double h = force_.x();
  const auto tension = [&](double s) { return std::hypot(h, cable_.weight * s - force_.y()); };
  const auto turning = [&](double s) { return cable_.weight * h / std::pow(tension(s), 2); };
  const auto layers = [&](double s) { return std::sqrt(tension(s) / cable_.bending_stiffness); };
  const double kappa_a = layers(0.0);
  const double kappa_b = layers(length_);
  const double turn_a = turning(0.0);
  const double turn_b = turning(length_);
  const auto node = [&](double s) {
    const double to_b = length_ - s;
    const double angle = catenaryAngle(cable_, h, force_.y(), s) +
                         turn_a / kappa_a * coshOverSinh(kappa_a * to_b, kappa_a * length_) -
                         turn_b / kappa_b * coshOverSinh(kappa_b * s, kappa_b * length_);
    const double turn = turning(s) - turn_a * sinhOverSinh(kappa_a * to_b, kappa_a * length_) -
                        turn_b * sinhOverSinh(kappa_b * s, kappa_b * length_);
    return Eigen::Vector2d(angle, turn * reference_length_);
  };
  for (Segment& segment : segments_) segment.node = node(segment.begin * length_);
  last_node_ = node(length_);
  segments_.front().node.y() = 0.0;
  last_node_.y() = 0.0;
}

bool MultipleShooting::meshFits() {
  if (hasShotBend()) return bendFits();
  return !hasQuietMiddle() || middleFits();
}

bool MultipleShooting::middleFits() {
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  std::size_t middle = 0;
  while (!segments_[middle].quiet) ++middle;
  const double begin = segments_[middle].begin * span;
  const double end = segments_[middle].end * span;
  slow_order_ = slowOrder(p, begin, end, kMiddleShare * shot_tolerance_.alpha);
  const auto fits = [&](double at_end, double layer, std::size_t count) {
    const double layers = layer * layerRate(p, std::abs(at_end - 0.5 * layer));
    return layers >= kShortLayer * layersNeeded(p, at_end, span, kMiddleShare * shot_tolerance_.alpha) &&
           layers <= kMostLayersPerSegment * static_cast<double>(count);
  };
  return slow_order_ > 0 && fits(0.0, begin, middle) && fits(span, span - end, segments_.size() - 1 - middle);
}

// From the catenary again: a shot from nodes that are not joined would not lead where the cable is, and a cable
// whose middle was quiet is near its catenary. A loop that bends more sharply than its own layers is not: it keeps its
// shape.
void MultipleShooting::replaceMesh(Middle middle) {
  const ShotParameters p = parameters();
  if (p.h < std::cbrt(p.q * p.q)) {
    const MultipleShooting before = *this;
    placeSegments(middle);
    keepShape(before);
  } else {
    placeSegments(middle);
    startNodes();
  }
}

}  // namespace cdpr_kinetostatics

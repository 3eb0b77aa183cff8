#include "cable/shooting_accuracy.h"

#include <algorithm>

namespace cdpr_kinetostatics {
namespace {

// Share of the tolerance that one integration step may use up: a cable has some ten steps whose errors add up.
constexpr double kStepShare = 0.1;

// Share of a step's error that a quiet interval may make: next to the shots its error shall not count.
constexpr double kQuietShare = 0.1;

// The cable counts as ruled by its stretch where the error of its angles has to be below this share of the tolerance.
// It is then shot in at least so many segments, each of which takes at least one step.
constexpr double kStretchRules = 0.1;
constexpr int kShotsWhereStretchRules = 16;

// Smallest angle scale: below it a step's error would drown in the rounding of doubles at the usual tolerances.
constexpr double kLeastAngleScale = 1e-6;

}  // namespace

double ShootingAccuracy::ofStep() const { return kStepShare * tolerance_ * angle_scale_; }

double ShootingAccuracy::ofQuietInterval() const { return kQuietShare * ofStep(); }

int ShootingAccuracy::fewestShots() const { return angle_scale_ < kStretchRules ? kShotsWhereStretchRules : 1; }

double angleScale(const CableProperties& cable, double length, double force, double turned) {
  // The slope at the ends of a beam on two supports that carries only its own weight: q L^3/(24 EI).
  const double beam_turn = cable.weight * length * length * length / (24.0 * cable.bending_stiffness);
  const double by_stretch = beam_turn < turned ? force / (cable.axial_stiffness * beam_turn) : turned;
  return std::clamp(std::min(turned, by_stretch), kLeastAngleScale, 1.0);
}

}  // namespace cdpr_kinetostatics

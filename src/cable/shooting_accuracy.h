// How accurate the parts of a bending cable's chain must be for the forces or the end point to meet the tolerance.
#pragma once

#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

class ShootingAccuracy {
 public:
  ShootingAccuracy() = default;

  // tolerance: relative, of the whole integration. angle_scale: the share of it that an error of the angle alpha may
  // have [rad].
  explicit ShootingAccuracy(double tolerance, double angle_scale = 1.0)
      : tolerance_(tolerance), angle_scale_(angle_scale) {}

  double tolerance() const { return tolerance_; }

  // Error of alpha [rad], and of the moment in its unit, that one integration step may make.
  double ofStep() const;

  // Error of alpha [rad] that the closed form of a quiet interval may make.
  double ofQuietInterval() const;

  // So many shots at least. Where stretch rules the forces, the errors of x and y matter, which the step control does
  // not look at; several segments keep the steps short.
  int fewestShots() const;

 private:
  double tolerance_ = 1e-8;
  double angle_scale_ = 1.0;
};

// The error of alpha that matters, over the tolerance. An error of alpha moves the end by that times the angle by which
// the cable turns. What this does to the forces depends on how the cable gives way: by its sag, which is as large as
// the turn, or, if its bending stiffness keeps it straight, by its stretch alone. force is the size of the force at A
// [N], turned the angle by which the cable turns between its ends [rad].
double angleScale(const CableProperties& cable, double length, double force, double turned);

}  // namespace cdpr_kinetostatics

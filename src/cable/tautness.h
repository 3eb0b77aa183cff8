// What "pushes", "under tension all along" and "slack" mean, for all layers. The first two look at forces, the last at
// the excess of a cable's length over its chord, L/chord.
#pragma once

#include <algorithm>
#include <cmath>

#include "cable/forces_at_a.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

// H of a vertical cable is zero but for rounding, which stays below this share of V.
inline constexpr double kVerticalRounding = 1e-12;

// The end A is pushed away from B's side: H < 0, by more than rounding. Only bending stiffness can carry that.
inline bool pushes(const ForcesAtA& forces) {
  return forces.horizontal < -kVerticalRounding * std::abs(forces.vertical);
}

// The same forces with H = 0 where it is negative by rounding only: closed forms need H >= 0.
inline ForcesAtA withoutRounding(const ForcesAtA& forces) {
  return {pushes(forces) ? forces.horizontal : std::max(forces.horizontal, 0.0), forces.vertical};
}

// The force (H, q s - V) along a catenary is nowhere zero and pulls everywhere: H > 0, or the cable hangs along a
// vertical on one of its ends alone. There the closed forms of the catenary and its derivatives exist.
inline bool pullsAllAlong(const CableProperties& cable, double length, const ForcesAtA& forces) {
  const bool on_one_end = forces.vertical < 0.0 || forces.vertical > cable.weight * length;
  return forces.horizontal > 0.0 || (on_one_end && !pushes(forces));
}

// Euler's load of a cable of this length as a strut with hinged ends, pi^2 EI/L^2 [N].
inline double bucklingForce(const CableProperties& cable, double length) {
  return cable.bending_stiffness * std::pow(M_PI / length, 2);
}

// A cable at a rough pose is longer than its chord for sure only beyond this excess; below it, the pose decides.
inline constexpr double kSurelyLonger = 1.0001;

// Below this excess the tension of a sagging cable changes with the inverse square of its sag, faster than a linear
// model can follow: Newton's steps are limited.
inline constexpr double kTautExcess = 1.01;

// Beyond this excess a cable hangs in a shape of its own, far from the straight line between its ends. Where the
// tension at A is least, which is where lengths may turn around, the excess is larger than this, too.
inline constexpr double kHangingExcess = 1.02;

// Beyond this excess users are told that a cable is slack: its length says little of the distance of its ends.
inline constexpr double kSlackExcess = 1.05;

}  // namespace cdpr_kinetostatics

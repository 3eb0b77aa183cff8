// How a cable's force follows its end over a step that is too long for a derivative: it turns with the chord.
//
// A stiff cable resists along its chord a thousand times as much as across it, so an end that moves on a circle about A
// leaves the tangent by a distance that a derivative takes for stretch. Written in the frame of the chord, the force is
// nearly linear in the chord's length and angle (docs/theory.md section 5, equation (35a)).
#pragma once

#include <Eigen/Core>

#include "cable/sagging_cable.h"
#include "geometry/cable_plane.h"

namespace cdpr_kinetostatics {

class ChordLaw {
 public:
  struct Value {
    Eigen::Vector2d forces;     // (H, V) [N]
    Eigen::Matrix2d stiffness;  // d(H, V)/d(x, y) [N/m]
  };

  ChordLaw() = default;

  // For a cable whose end is in equilibrium at (plane.x, plane.y), with stiffness d(H, V)/d(x, y) and by_length
  // d(H, V)/dL there, once it has the unstrained length new_length [m].
  ChordLaw(const SaggingCable& cable, const CablePlane& plane, const Eigen::Matrix2d& stiffness,
           const Eigen::Vector2d& by_length, double new_length);

  // With the end at (plane.x, plane.y), the chord turned by less than a quarter.
  Value at(const CablePlane& plane) const;

  // On the platform, of such a value [N], world axes.
  Eigen::Vector3d forceOnPlatform(const CablePlane& plane, const Value& value) const;

 private:
  double weight_ = 0.0;                                  // of the cable at its new length [N]
  Eigen::Vector2d departure_ = Eigen::Vector2d::Zero();  // where the rope leaves its pulley: the chord begins there
  double chord_ = 0.0;                                   // where the law begins [m]
  Eigen::Vector2d along_;                                // unit vector of the chord there
  // f = (H, q L/2 - V) there, at the new length, and how it changes with the chord's length [N/m] and, beyond turning
  // with the chord, with the chord's angle [N/rad].
  Eigen::Vector2d force_, by_chord_, by_turn_;
};

}  // namespace cdpr_kinetostatics

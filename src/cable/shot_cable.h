// One bending cable under its forces in SI units, and the units in which it is shot (docs/theory.md section 3,
// "Shots").
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "cable/rope_on_pulley.h"
#include "cable/shot.h"
#include "cable/tautness.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

struct ShotCable {
  CableProperties properties;                       // EI > 0; an infinite EA is the inextensible cable
  double length = 0.0;                              // unstrained, of the free part [m]
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  // (H, V) at A [N]
  double unit_force = 1.0;                          // F0 [N]
  double unit_length = 1.0;                         // l0 [m], the bending layer's thickness under F0
  double unit_moment = 1.0;                         // F0 l0 [N m]

  // Takes the units from the properties, the length and the force as they are now. They stay as they are while the
  // force and the length change, so that angles and moments keep their numbers.
  void chooseUnits() {
    const double t_a = force.norm();
    const double t_b = std::hypot(force.x(), force.y() - properties.weight * length);
    unit_force = std::max({t_a, t_b, bucklingForce()});
    unit_length = std::sqrt(properties.bending_stiffness / unit_force);
    unit_moment = unit_force * unit_length;
  }

  // Euler's load of the cable as a strut with hinged ends [N].
  double bucklingForce() const { return cdpr_kinetostatics::bucklingForce(properties, length); }

  // The length in units of l0: t runs from 0 to span.
  double span() const { return length / unit_length; }

  // The moment at A, where the cable leaves a pulley, in its unit; none at an eyelet.
  double momentAtA() const { return momentAtDeparture(properties) / unit_moment; }

  // The constants of (16).
  ShotParameters parameters() const {
    return {force.x() / unit_force, force.y() / unit_force, properties.weight * unit_length / unit_force,
            unit_force / properties.axial_stiffness};
  }
};

}  // namespace cdpr_kinetostatics

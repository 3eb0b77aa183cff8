// No answer and no refusal of a solver holds a NaN or an infinity.
#pragma once

#include <cmath>

#include "cdpr_kinetostatics/cable/cable_solution.h"

namespace cdpr_kinetostatics {

inline bool isFinite(const CableSolution& c) {
  bool finite = c.end_jacobian.allFinite() && c.force_jacobian.allFinite();
  for (const double value :
       {c.length, c.strained_length, c.x, c.y, c.horizontal_force, c.vertical_force_a, c.tension_a, c.tension_b,
        c.angle_a, c.angle_b, c.sag, c.max_moment, c.max_shear, c.closure_residual, c.moment_residual}) {
    finite = finite && std::isfinite(value);
  }
  for (const ProfilePoint& p : c.profile) {
    for (const double value : {p.s, p.x, p.y, p.alpha, p.moment, p.tension, p.shear}) {
      finite = finite && std::isfinite(value);
    }
  }
  return finite;
}

}  // namespace cdpr_kinetostatics

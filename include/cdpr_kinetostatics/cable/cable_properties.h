// The physical properties of one cable.
#pragma once

#include "cdpr_kinetostatics/cable/guide_pulley.h"

namespace cdpr_kinetostatics {

// Any of them may be zero but the axial stiffness. Infinity is a valid axial stiffness (inextensible).
struct CableProperties {
  double axial_stiffness = 0.0;    // EA [N]
  double bending_stiffness = 0.0;  // EI [N m^2]
  double weight = 0.0;             // q = rho g A0 [N/m], per unstrained metre

  GuidePulley pulley = {};   // where the cable begins
  double dead_length = 0.0;  // way from the drum to the point where the rope reaches the pulley or eyelet [m]
};

}  // namespace cdpr_kinetostatics

// The physical properties of one cable.
#pragma once

namespace cdpr_kinetostatics {

// Any of them may be zero but the axial stiffness. Infinity is a valid axial stiffness (inextensible).
struct CableProperties {
  double axial_stiffness = 0.0;    // EA [N]
  double bending_stiffness = 0.0;  // EI [N m^2]
  double weight = 0.0;             // q = rho g A0 [N/m], per unstrained metre
};

}  // namespace cdpr_kinetostatics

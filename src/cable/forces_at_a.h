// The force at the end A, which with the length determines the whole cable (docs/theory.md section 1).
#pragma once

#include <cmath>

namespace cdpr_kinetostatics {

struct ForcesAtA {
  double horizontal = 0.0;  // H [N]
  double vertical = 0.0;    // V [N]

  double tension() const { return std::hypot(horizontal, vertical); }  // T_A [N]
};

}  // namespace cdpr_kinetostatics

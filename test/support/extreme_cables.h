// Cables from everywhere that the bending model may be asked about: a Latin hypercube, the same every time.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

struct ExtremeCable {
  CableProperties cable;
  double length = 0.0;       // [m]
  double x = 0.0, y = 0.0;   // end B [m]
  double chord = 0.0;        // [m]
  double inclination = 0.0;  // of the chord [rad]
  bool taut = false;         // chord > length; else slack
  double strain = 0.0;       // taut: chord/length - 1; slack: weight over EA
  double weight = 0.0;       // over the nominal tension; 1 if slack
  double force = 0.0;        // nominal tension T0 [N]: EA strain if taut, else the weight
  double layers = 0.0;       // kappa L = L sqrt(T0/EI)

  // Why no physical answer can be expected; empty if there is one.
  std::string corner() const;
};

std::ostream& operator<<(std::ostream& out, const ExtremeCable& c);

// chord 1 mm ... 10 km, inclination -90 ... 90 degrees and every eighth cable exactly vertical, kappa L 1e-2 ... 1e6,
// T0 1e-3 ... 1e7 N, strain 1e-7 ... 5e-2, every second cable taut with weight/T0 0 ... 1 (an eighth weightless), the
// others slack with L/chord - 1 from 1e-6 to 4. All but inclination and weight are uniform in the logarithm.
std::vector<ExtremeCable> extremeCables(int count);

}  // namespace cdpr_kinetostatics

// Random cables, the same every time: what the properties of one cable are tested on.
#pragma once

#include <ostream>
#include <random>

#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

// A cable of unstrained length `length` between A = (0, 0) and B = (x, y).
struct CableCase {
  CableProperties cable;
  double length = 0.0;
  double x = 0.0;
  double y = 0.0;
  double layers = 0.0;  // kappa L, with the tension at A of the catenary

  double chord() const;
};

std::ostream& operator<<(std::ostream& out, const CableCase& c);

// Ranges are sampled uniformly in the logarithm, inclinations uniformly.
struct RandomCables {
  double shortest_chord = 0.1, longest_chord = 100.0;  // [m]
  double fewest_layers = 1.0, most_layers = 1000.0;    // kappa L
  double least_strain = 1e-6, largest_strain = 1e-2;   // T/EA
  double most_slack = 3.0;                             // L/chord, of the slack half
  double steepest = 1.5;                               // |inclination| [rad]

  // The next case of the sequence. Every second cable is slack.
  CableCase next();

 private:
  double logUniform(double low, double high);

  std::mt19937 generator_{20240229};
  int count_ = 0;
};

}  // namespace cdpr_kinetostatics

// Random states of one cable's closure: a turned platform, forces near those that close the cable.
#pragma once

#include <ostream>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "robot_cases.h"
#include "robot_residuals.h"

namespace cdpr_kinetostatics {

struct ClosureKind {
  const char* name;
  double least_excess, most_excess;  // length over chord, less 1
  double steepest;                   // sine of the chord's slope, at most
  double beside;                     // share of the chord that B lies off the vertical through A; < 0: anywhere
  bool inextensible;
  double pulley_radius = 0.0;  // [m]; the rope comes from below or from above
  double dead_length = 0.0;    // [m]
};
inline std::ostream& operator<<(std::ostream& out, const ClosureKind& kind) { return out << kind.name; }

struct ClosureState {
  CableProperties cable;
  Eigen::Vector3d anchor, attachment;
  double chord = 0.0;
  ParameterBlocks parameters;  // position, orientation, (H/x, V), length
};

ClosureState randomClosure(const ClosureKind& kind, Dice* dice);

}  // namespace cdpr_kinetostatics

// The reference values of test/golden/cables.csv and pulley_cables.csv.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

struct GoldenCable {
  int row = 0;
  CableProperties cable;
  double x = 0.0, y = 0.0, length = 0.0;
  double h = 0.0, v = 0.0, tension_a = 0.0;
  double angle_a = 0.0, angle_b = 0.0;
  double catenary_h = 0.0, catenary_v = 0.0;
};

std::ostream& operator<<(std::ostream& out, const GoldenCable& golden);

// A cable on a guide pulley; x, y and length count from where the rope reaches it.
struct GoldenPulleyCable {
  int row = 0;
  CableProperties cable;
  double x = 0.0, y = 0.0, length = 0.0;
  double h = 0.0, v = 0.0, tension_a = 0.0;
  double angle_a = 0.0, angle_b = 0.0, wrap = 0.0, free_length = 0.0, max_moment = 0.0;
};

std::ostream& operator<<(std::ostream& out, const GoldenPulleyCable& golden);

// Reads cables.csv in the directory; throws std::runtime_error if it is missing or malformed.
std::vector<GoldenCable> goldenCables(const std::string& directory);
// The same of pulley_cables.csv.
std::vector<GoldenPulleyCable> goldenPulleyCables(const std::string& directory);

}  // namespace cdpr_kinetostatics

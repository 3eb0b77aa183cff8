// The keys of the `pulley` and `winch` maps: where a cable begins, and what its drive reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot/yaml_map.h"

namespace cdpr_kinetostatics {

struct WinchKeys {
  std::optional<double> radius;  // [m]
  std::optional<RopeFrom> rope_from;
  std::optional<double> dead_length;  // [m]
  std::optional<double> scale;        // [m] per unit of what the drive reports
  std::optional<double> offset;       // [m]
};

// Of a map that may have `pulley` and `winch`: the robot's, for all cables, or a point's. Adds a warning for keys
// without meaning; throws for pulleys that do not swivel about the vertical.
WinchKeys readWinchKeys(YamlMap& map, std::vector<std::string>& warnings);

// Each key of the cable's own, else that for all cables; without either it stays what it is.
void resolveWinch(const WinchKeys& own, const WinchKeys& defaults, CableDescription& cable);

}  // namespace cdpr_kinetostatics

// The keys of a `cable` map: defaults, overrides, and what a solid round section implies.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot/yaml_map.h"

namespace cdpr_kinetostatics {

struct GivenNumber {
  double value;
  std::string path;  // where the user gave it
};

// By key: axial_stiffness, bending_stiffness, linear_density, radius, diameter, youngs_modulus, density, fill_factor,
// tension_min, tension_max.
using CableKeys = std::map<std::string, GivenNumber>;

// Adds a warning for keys without meaning.
CableKeys readCableKeys(YamlMap map, std::vector<std::string>& warnings);

// Fills properties and tension limits of cable. here is the path where a missing key would belong.
void resolveCable(const CableKeys& keys, const std::string& here, double gravity, CableDescription& cable);

// Throws when both are given and differ by more than rounding; otherwise whichever is given.
std::optional<GivenNumber> agree(const std::optional<GivenNumber>& first, const std::optional<GivenNumber>& second);

}  // namespace cdpr_kinetostatics

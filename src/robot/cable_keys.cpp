#include "robot/cable_keys.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cdpr_kinetostatics {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kAgreement = 1e-6;  // two values this near are one quantity, rounded differently, relative [-]

struct KeyRule {
  const char* key;
  Range range;
  const char* unit;
};

constexpr KeyRule kRules[] = {
    {"axial_stiffness", Range::kPositive, "N"},
    {"bending_stiffness", Range::kNonNegative, "N m^2"},
    {"linear_density", Range::kNonNegative, "kg/m"},
    {"radius", Range::kPositive, "m"},
    {"diameter", Range::kPositive, "m"},
    {"youngs_modulus", Range::kPositive, "Pa"},
    {"density", Range::kNonNegative, "kg/m^3"},
    {"fill_factor", Range::kFraction, ""},
    {"tension_min", Range::kNonNegative, "N"},
    {"tension_max", Range::kPositive, "N"},
};

std::optional<GivenNumber> find(const CableKeys& keys, const std::string& key) {
  const auto found = keys.find(key);
  if (found == keys.end()) return std::nullopt;
  return found->second;
}

// EA, EI and mass per metre of a solid round section, as far as radius, modulus and density tell.
struct Section {
  std::optional<GivenNumber> axial_stiffness;
  std::optional<GivenNumber> bending_stiffness;
  std::optional<GivenNumber> linear_density;
};

Section sectionOf(const CableKeys& keys) {
  std::optional<GivenNumber> radius = find(keys, "radius");
  std::optional<GivenNumber> half_diameter = find(keys, "diameter");
  if (half_diameter) half_diameter = GivenNumber{half_diameter->value / 2.0, half_diameter->path + "/2"};
  radius = agree(radius, half_diameter);

  for (const char* key : {"youngs_modulus", "density", "fill_factor"}) {
    const std::optional<GivenNumber> given = find(keys, key);
    if (given && !radius) {
      throw std::invalid_argument(given->path + " = " + numberText(given->value) +
                                  ": expected radius or diameter beside it, it describes a round section");
    }
  }

  Section section;
  if (!radius) return section;
  const std::optional<GivenNumber> fill = find(keys, "fill_factor");
  const double disc = kPi * std::pow(radius->value, 2);
  const double area = disc * (fill ? fill->value : 1.0);
  const double second_moment = disc * std::pow(radius->value, 2) / 4.0;
  const std::string with_fill = fill ? ", " + fill->path : "";
  if (const auto modulus = find(keys, "youngs_modulus")) {
    const std::string source = radius->path + ", " + modulus->path;
    section.axial_stiffness = GivenNumber{modulus->value * area, source + with_fill};
    section.bending_stiffness = GivenNumber{modulus->value * second_moment, source};
  }
  if (const auto density = find(keys, "density")) {
    section.linear_density = GivenNumber{density->value * area, radius->path + ", " + density->path + with_fill};
  }
  return section;
}

double require(const std::optional<GivenNumber>& given, const std::string& key, const std::string& here,
               const std::string& expected) {
  if (given) return given->value;
  const std::string both = here == "cable" ? "" : " and so is cable." + key;
  throw std::invalid_argument(here + "." + key + " is missing" + both + ": expected " + expected);
}

}  // namespace

CableKeys readCableKeys(YamlMap map, std::vector<std::string>& warnings) {
  CableKeys keys;
  for (const KeyRule& rule : kRules) {
    if (const auto value = map.optionalNumber(rule.key, rule.range, rule.unit)) {
      keys[rule.key] = GivenNumber{*value, map.pathOf(rule.key)};
    }
  }
  if (map.has("mass")) {
    warnings.push_back(map.pathOf("mass") + " is ignored: it is the mass of a simulated link; give linear_density");
  }
  for (const std::string& path : map.unread()) warnings.push_back(path + " is ignored: no such key");
  return keys;
}

void resolveCable(const CableKeys& keys, const std::string& here, double gravity, CableDescription& cable) {
  const Section section = sectionOf(keys);
  cable.properties.axial_stiffness =
      require(agree(find(keys, "axial_stiffness"), section.axial_stiffness), "axial_stiffness", here,
              "EA, a number > 0 [N], or radius and youngs_modulus of a solid round section");
  cable.properties.bending_stiffness =
      require(agree(find(keys, "bending_stiffness"), section.bending_stiffness), "bending_stiffness", here,
              "EI, a number >= 0 [N m^2] (0 for a perfectly flexible cable), or radius and youngs_modulus of a solid "
              "round section");
  cable.properties.weight =
      gravity * require(agree(find(keys, "linear_density"), section.linear_density), "linear_density", here,
                        "a number >= 0 [kg/m], or radius and density of a round section");

  cable.tension_max = require(find(keys, "tension_max"), "tension_max", here, "the largest tension allowed, > 0 [N]");
  const std::optional<GivenNumber> lowest = find(keys, "tension_min");
  cable.tension_min = lowest ? lowest->value : 0.0;
  if (cable.tension_min >= cable.tension_max) {
    const GivenNumber highest = keys.at("tension_max");
    throw std::invalid_argument(lowest->path + " = " + numberText(lowest->value) + ": expected less than " +
                                highest.path + " = " + numberText(highest.value));
  }
}

std::optional<GivenNumber> agree(const std::optional<GivenNumber>& first, const std::optional<GivenNumber>& second) {
  if (!first || !second) return first ? first : second;
  const double largest = std::max(std::abs(first->value), std::abs(second->value));
  if (std::abs(first->value - second->value) > kAgreement * largest) {
    throw std::invalid_argument(first->path + " = " + numberText(first->value) + ": expected agreement with " +
                                numberText(second->value) + " from " + second->path + ", or only one of them");
  }
  return first;
}

}  // namespace cdpr_kinetostatics

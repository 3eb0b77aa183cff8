#include "robot/winch_keys.h"

#include <cmath>

namespace cdpr_kinetostatics {
namespace {

constexpr const char* kOnlyVertical =
    "[0, 0, 1] or no such key: only pulleys that swivel about a vertical axis are described. For a tilted one the "
    "cable's plane would not be vertical";

// What users may write for the swivel's axis, as a vector.
constexpr const char* kAxisKeys[] = {"axis", "swivel_axis"};

void refuseTilted(YamlMap& pulley) {
  for (const char* key : kAxisKeys) {
    if (!pulley.has(key)) continue;
    const YAML::Node list = pulley.node(key);
    if (!list.IsSequence() || list.size() != 3) pulley.fail(key, kOnlyVertical);
    const Eigen::Vector3d axis = pulley.vector(key, Range::kAny, "");
    if (axis.x() != 0.0 || axis.y() != 0.0 || axis.z() == 0.0) pulley.fail(key, kOnlyVertical);
  }
}

std::optional<RopeFrom> readSide(YamlMap& pulley) {
  if (!pulley.has("rope_from")) return std::nullopt;
  const std::string side = pulley.textOr("rope_from", "");
  if (side == "below") return RopeFrom::kBelow;
  if (side == "above") return RopeFrom::kAbove;
  pulley.fail("rope_from", "below, where the rope comes up to the pulley and goes over its top, or above");
}

void warnUnread(const YamlMap& map, std::vector<std::string>& warnings) {
  for (const std::string& path : map.unread()) warnings.push_back(path + " is ignored: no such key");
}

template <typename T>
void take(const std::optional<T>& own, const std::optional<T>& otherwise, T& value) {
  value = own.value_or(otherwise.value_or(value));
}

}  // namespace

WinchKeys readWinchKeys(YamlMap& map, std::vector<std::string>& warnings) {
  WinchKeys keys;
  if (map.has("pulley")) {
    YamlMap pulley = map.map("pulley");
    refuseTilted(pulley);
    keys.radius = pulley.optionalNumber("radius", Range::kNonNegative, "m");
    keys.rope_from = readSide(pulley);
    warnUnread(pulley, warnings);
  }
  if (map.has("winch")) {
    YamlMap winch = map.map("winch");
    keys.dead_length = winch.optionalNumber("dead_length", Range::kNonNegative, "m");
    keys.scale = winch.optionalNumber("scale", Range::kAny, "m per unit of position");
    if (keys.scale == 0.0) {
      winch.fail("scale", "a number that is not 0 [m per unit of position]; 1 where the drive reports metres");
    }
    keys.offset = winch.optionalNumber("offset", Range::kAny, "m");
    warnUnread(winch, warnings);
  }
  return keys;
}

void resolveWinch(const WinchKeys& own, const WinchKeys& defaults, CableDescription& cable) {
  take(own.radius, defaults.radius, cable.properties.pulley.radius);
  take(own.rope_from, defaults.rope_from, cable.properties.pulley.rope_from);
  take(own.dead_length, defaults.dead_length, cable.properties.dead_length);
  take(own.scale, defaults.scale, cable.scale);
  take(own.offset, defaults.offset, cable.offset);
}

}  // namespace cdpr_kinetostatics

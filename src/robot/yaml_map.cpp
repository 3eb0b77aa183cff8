#include "robot/yaml_map.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "robot/yaml_scalar.h"

namespace cdpr_kinetostatics {
namespace {

bool lies(double value, Range range) {
  if (!std::isfinite(value)) return false;
  switch (range) {
    case Range::kAny:
      return true;
    case Range::kPositive:
      return value > 0.0;
    case Range::kNonNegative:
      return value >= 0.0;
    case Range::kFraction:
      return value > 0.0 && value <= 1.0;
  }
  return false;
}

std::string describe(Range range, const std::string& unit) {
  const std::string brackets = unit.empty() ? "" : " [" + unit + "]";
  switch (range) {
    case Range::kAny:
      return "finite" + brackets;
    case Range::kPositive:
      return "finite and > 0" + brackets;
    case Range::kNonNegative:
      return "finite and >= 0" + brackets;
    case Range::kFraction:
      return "> 0 and <= 1" + brackets;
  }
  return "";
}

std::optional<double> readNumber(const YAML::Node& node, Range range) {
  const std::optional<double> value = node.IsScalar() ? numberOf(readScalar(node)) : std::nullopt;
  return value && lies(*value, range) ? value : std::nullopt;
}

}  // namespace

YamlMap::YamlMap(const YAML::Node& node, const std::string& path) : node_(node), path_(path) {
  const std::string here = path.empty() ? "robot" : path;
  if (!node.IsDefined()) throw std::invalid_argument(here + " is missing: expected a map of keys");
  if (!node.IsMap()) throw std::invalid_argument(here + " = " + quote(node) + ": expected a map of keys");
}

bool YamlMap::has(const std::string& key) { return node(key).IsDefined(); }

YAML::Node YamlMap::node(const std::string& key) {
  known_.insert(key);
  const YAML::Node& constant = node_;  // operator[] of a constant node does not insert the key
  return constant[key];
}

std::string YamlMap::pathOf(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

double YamlMap::number(const std::string& key, Range range, const std::string& unit) {
  const std::optional<double> value = optionalNumber(key, range, unit);
  if (!value) fail(key, "a number, " + describe(range, unit));
  return *value;
}

std::optional<double> YamlMap::optionalNumber(const std::string& key, Range range, const std::string& unit) {
  if (!has(key)) return std::nullopt;
  const std::optional<double> value = readNumber(node(key), range);
  if (!value) fail(key, "a number, " + describe(range, unit));
  return value;
}

Eigen::Vector3d YamlMap::vector(const std::string& key, Range range, const std::string& unit) {
  const std::string expected = "a list of 3 numbers, " + describe(range, unit);
  const YAML::Node list = node(key);
  if (!list.IsDefined() || !list.IsSequence() || list.size() != 3) fail(key, expected);
  Eigen::Vector3d result;
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> value = readNumber(list[i], range);
    if (!value) fail(key, expected);
    result[i] = *value;
  }
  return result;
}

Eigen::Vector3d YamlMap::vectorOr(const std::string& key, Range range, const std::string& unit,
                                  const Eigen::Vector3d& fallback) {
  return has(key) ? vector(key, range, unit) : fallback;
}

std::string YamlMap::textOr(const std::string& key, const std::string& fallback) {
  if (!has(key)) return fallback;
  const YAML::Node found = node(key);
  const std::optional<std::string> word = found.IsScalar() ? wordOf(readScalar(found)) : std::nullopt;
  if (!word || word->empty()) {
    fail(key, "a name that is not empty, in quotes if it looks like a number with a point, or like true or false");
  }
  return *word;
}

YamlMap YamlMap::map(const std::string& key) { return YamlMap(node(key), pathOf(key)); }

std::vector<YamlMap> YamlMap::maps(const std::string& key) {
  const YAML::Node list = node(key);
  if (!list.IsDefined() || !list.IsSequence() || list.size() == 0) fail(key, "a list of at least one map of keys");
  std::vector<YamlMap> result;
  for (std::size_t i = 0; i < list.size(); ++i) {
    result.emplace_back(list[i], pathOf(key) + "[" + std::to_string(i) + "]");
  }
  return result;
}

std::vector<std::string> YamlMap::present(const std::set<std::string>& keys) {
  std::vector<std::string> paths;
  for (const std::string& key : keys) {
    if (has(key)) paths.push_back(pathOf(key));
  }
  return paths;
}

std::vector<std::string> YamlMap::unread() const {
  std::vector<std::string> paths;
  for (const auto& entry : node_) {
    if (known_.count(entry.first.Scalar()) == 0) paths.push_back(pathOf(entry.first.Scalar()));
  }
  return paths;
}

void YamlMap::fail(const std::string& key, const std::string& expected) const {
  const YAML::Node value = node_[key];
  const std::string found = value.IsDefined() ? " = " + quote(value) : " is missing";
  throw std::invalid_argument(pathOf(key) + found + ": expected " + expected);
}

std::string numberText(double value) {
  std::ostringstream text;
  text.precision(9);
  text << value;
  return text.str();
}

}  // namespace cdpr_kinetostatics

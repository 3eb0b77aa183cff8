// A YAML map that knows where it stands in the document, so that every complaint names key and value.
#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cdpr_kinetostatics {

// What a number may be; all are finite.
enum class Range { kAny, kPositive, kNonNegative, kFraction };

class YamlMap {
 public:
  // Of a plain tree (yaml_tree.h). Throws std::invalid_argument unless node is a map. path is empty at the root.
  YamlMap(const YAML::Node& node, const std::string& path);

  // Each key that is read counts as known.
  bool has(const std::string& key);
  YAML::Node node(const std::string& key);
  std::string pathOf(const std::string& key) const;

  double number(const std::string& key, Range range, const std::string& unit);
  std::optional<double> optionalNumber(const std::string& key, Range range, const std::string& unit);
  Eigen::Vector3d vector(const std::string& key, Range range, const std::string& unit);
  Eigen::Vector3d vectorOr(const std::string& key, Range range, const std::string& unit,
                           const Eigen::Vector3d& fallback);
  std::string textOr(const std::string& key, const std::string& fallback);
  YamlMap map(const std::string& key);
  std::vector<YamlMap> maps(const std::string& key);  // a list of maps, at least one

  // Paths of the given keys that are present; they count as known from then on.
  std::vector<std::string> present(const std::set<std::string>& keys);
  // Paths of the keys that nothing has asked for.
  std::vector<std::string> unread() const;

  [[noreturn]] void fail(const std::string& key, const std::string& expected) const;

 private:
  YAML::Node node_;
  std::string path_;
  std::set<std::string> known_;
};

// Shortest text that reads back as about the same value, for messages.
std::string numberText(double value);

}  // namespace cdpr_kinetostatics

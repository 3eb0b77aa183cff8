// What roslaunch makes of YAML: the rows of test/golden/yaml_scalars.json.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace cdpr_kinetostatics {

struct YamlReading {
  std::string text;
  std::string kind;  // whole, number, flag, text, nothing, list, map or refused
  YAML::Node value;  // numbers with a point are texts
};

inline std::vector<YamlReading> yamlReadings(const std::string& of) {
  std::vector<YamlReading> readings;
  for (const YAML::Node& row : YAML::LoadFile(std::string(TEST_DATA_DIR) + "/yaml_scalars.json")[of]) {
    readings.push_back({row[0].as<std::string>(), row[1].as<std::string>(), row[2]});
  }
  return readings;
}

}  // namespace cdpr_kinetostatics

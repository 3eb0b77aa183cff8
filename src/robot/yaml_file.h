// The one document of a YAML text or file.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace cdpr_kinetostatics {

// Throws YAML::Exception if the text is no YAML, std::invalid_argument if something follows the first document:
// roslaunch refuses that too. yaml-cpp alone drops it without a word.
YAML::Node loadDocument(const std::string& text);

// The same of a file. Throws std::invalid_argument if it cannot be read.
YAML::Node loadYamlFile(const std::string& path);

}  // namespace cdpr_kinetostatics

// A YAML document as roslaunch would hand it to the parameter server.
#pragma once

#include <yaml-cpp/yaml.h>

namespace cdpr_kinetostatics {

// A copy of the tree: merges (<<: *rope) are done, aliases are written out, and each scalar has a meaning
// (yaml_scalar.h). Throws std::invalid_argument, whose text says where, what was found and what was expected: also for
// a key that is given twice, of which roslaunch would keep the last without a word.
YAML::Node plainTree(const YAML::Node& root);

}  // namespace cdpr_kinetostatics

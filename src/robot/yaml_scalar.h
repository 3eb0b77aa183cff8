// What a scalar of a YAML file means: what roslaunch makes of it before the node sees it. So programs that read a file
// themselves and the node, which gets parameters, read the same robot.
//
// roslaunch reads YAML 1.1 by PyYAML and knows angles besides. test/golden/yaml_scalars.json holds what it makes of
// many scalars.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

namespace cdpr_kinetostatics {

struct YamlScalar {
  enum class Kind {
    kNothing,      // null, ~, or no text at all
    kFlag,         // true, false, yes, no, on, off
    kWholeNumber,  // passes ROS as an int32
    kNumber,
    kText,
    kRefused,  // roslaunch cannot pass it on, or it is beyond what is understood here
  };
  Kind kind = Kind::kNothing;
  bool flag = false;
  double number = 0.0;
  std::string text;  // of kText; of kRefused: what is expected instead
};

// The node must be a scalar or null.
YamlScalar readScalar(const YAML::Node& node);

// Its number, also of a text that is nothing but a decimal number: YAML 1.1 takes 1e3 for text.
std::optional<double> numberOf(const YamlScalar& scalar);

// Its text, or its digits if it is a whole number.
std::optional<std::string> wordOf(const YamlScalar& scalar);

// The node in a line, for messages; cut if it is long.
std::string quote(const YAML::Node& node);

}  // namespace cdpr_kinetostatics

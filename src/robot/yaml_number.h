// Numbers as they are written in YAML 1.1, which PyYAML reads: 010 is 8, 0x1F is 31, 1_000 is 1000, 1:30 is 90.
#pragma once

#include <optional>
#include <string>

namespace cdpr_kinetostatics {

// A whole number of YAML 1.1, of any size; beyond 2^53 it is rounded. NaN if it has no digits, as 0x_, where PyYAML
// gives up.
std::optional<double> readWholeNumber(const std::string& text);

// A number with a point, infinity or NaN.
std::optional<double> readPointNumber(const std::string& text);

// A decimal number as everywhere else, of one meaning only: no zero before other digits, which makes it octal for YAML.
// YAML 1.1 takes some of these, as 1e3 and -.5, for text.
std::optional<double> readDecimal(const std::string& text);

// The same with any zeros in front, as Python's float() takes it.
std::optional<double> readPythonFloat(const std::string& text);

}  // namespace cdpr_kinetostatics

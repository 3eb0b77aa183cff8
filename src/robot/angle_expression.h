// Angles as roslaunch computes them for "!degrees 10", deg(10), "!radians pi/2" and rad(pi/2).
#pragma once

#include <optional>
#include <string>

namespace cdpr_kinetostatics {

// A decimal number, with spaces around it.
std::optional<double> degreesToRadians(const std::string& number);

// Numbers and pi, with + - * / and parentheses. roslaunch hands the text to Python, which knows more: nothing is
// returned for that.
std::optional<double> evaluateRadians(const std::string& expression);

}  // namespace cdpr_kinetostatics

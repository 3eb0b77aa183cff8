// Lengths and times as people read them: three digits or two, and a prefix.
#pragma once

#include <string>

namespace cdpr_kinetostatics {

std::string asLength(double metres);
std::string asTime(double seconds);

}  // namespace cdpr_kinetostatics

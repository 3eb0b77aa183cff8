// Sentences from numbers and words.
#pragma once

#include <sstream>
#include <string>

namespace cdpr_kinetostatics {

template <typename... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream out;
  out.precision(10);
  (out << ... << parts);
  return out.str();
}

}  // namespace cdpr_kinetostatics

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

// One sentence after the other; either may be missing.
inline std::string joined(const std::string& first, const std::string& second) {
  return first + (first.empty() || second.empty() ? "" : "; ") + second;
}

}  // namespace cdpr_kinetostatics

// From a double to the number of pieces, segments or terms that it asks for.
#pragma once

#include <cmath>

namespace cdpr_kinetostatics {

// The least whole number that is not below value, kept between least and most; most for what is not a number. A cast
// of a double that does not fit is undefined, and std::clamp lets a NaN through.
inline int boundedCount(double value, int least, int most) {
  if (value <= static_cast<double>(least)) return least;
  return value < static_cast<double>(most) ? static_cast<int>(std::ceil(value)) : most;
}

}  // namespace cdpr_kinetostatics

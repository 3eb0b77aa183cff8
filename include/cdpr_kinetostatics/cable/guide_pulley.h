// The guide pulley from which a cable leaves, and the side from which the rope reaches it.
#pragma once

#include <cstdint>

namespace cdpr_kinetostatics {

// From below the rope goes up to the pulley, over its top and away; from above it goes down and under its bottom.
enum class RopeFrom : std::uint8_t { kBelow = 0, kAbove = 1 };

// It swivels about the vertical through the point A0 where the rope reaches it, so it always stands in the vertical
// plane of the cable. A radius of 0 is an eyelet: the rope leaves from A0 itself.
struct GuidePulley {
  double radius = 0.0;  // to the middle of the rope [m]
  RopeFrom rope_from = RopeFrom::kBelow;
};

}  // namespace cdpr_kinetostatics

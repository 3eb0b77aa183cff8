// When Newton's methods choose integration steps anew, and when they have settled (docs/theory.md section 3, "Frozen
// grids"). One schedule for all of them: a single cable, the coupled robot, its inverse, a Ceres block's closure.
#pragma once

namespace cdpr_kinetostatics {

// An adaptive integrator's result jumps when a step is added, which Newton's method takes for a residual. Below this
// size of an iteration's step, relative to tension or in rad, the steps chosen last are repeated instead. The jumps are
// of the size of the integration's tolerance, which is far below this.
inline constexpr double kFreezeBelow = 1e-3;

// After so many iterations the steps are repeated in any case: where a cable hardly stretches, its forces magnify the
// error of integration, and would jitter with the steps for ever.
inline constexpr int kAdaptiveIterations = 10;

// Whether the iteration after this one, counted from 0 and of this size, chooses integration steps anew.
inline bool choosesStepsNext(double size, int iteration) {
  return size > kFreezeBelow && iteration < kAdaptiveIterations;
}

// Steps of Newton's method shrink quadratically until rounding takes over: those that are small and have stopped to
// shrink are rounding. The largest size that can be meant: a step of this size would be followed by one of its square.
inline constexpr double kRoundingSize = 1e-5;

inline bool hasStoppedShrinking(double size, double last_size) {
  return size < kRoundingSize && size >= 0.5 * last_size;
}

}  // namespace cdpr_kinetostatics

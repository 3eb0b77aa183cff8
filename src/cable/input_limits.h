// What the solvers accept. Beyond these limits a number is a mistake, of units or of a sign, not a robot; the refusal
// states the limit. One place for cables, robots, estimates, messages and parameters.
#pragma once

#include <cstddef>

namespace cdpr_kinetostatics {

// Lengths, coordinates, accuracies [m]. The longest cable robot has spans of a kilometre.
inline constexpr double kLargestLength = 1e6;

// Forces, tensions and weights per metre [N, N/m], moments [N m]. The strongest rope carries 1e8 N.
inline constexpr double kLargestForce = 1e12;

// Relative tolerances: finer ones drown in the rounding of doubles, coarser ones are no solution.
inline constexpr double kFinestTolerance = 1e-13;
inline constexpr double kCoarsestTolerance = 0.1;

// Points of a profile: as many as a picture of any size can show.
inline constexpr int kMostProfilePoints = 100000;

// Cables of a robot. The largest built has some dozens; the time of inverse kinetostatics grows with the cube of the
// number.
inline constexpr std::size_t kMostCables = 256;

// Quaternions this near to unit length are taken as unit.
inline constexpr double kUnitNorm = 1e-6;

}  // namespace cdpr_kinetostatics

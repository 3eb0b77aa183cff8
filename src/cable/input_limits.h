// What the solvers accept. Beyond these limits a number is a mistake, of units or of a sign, not a robot; the refusal
// states the limit. One place for cables, robots, estimates, messages and parameters.
#pragma once

#include <cstddef>

namespace cdpr_kinetostatics {

// Lengths, coordinates, accuracies [m]. The longest cable robot has spans of a kilometre.
inline constexpr double kLargestLength = 1e6;

// Lengths of cables [m]: shorter ones are thinner than any fibre is thick. What divides by a length stays a number.
inline constexpr double kShortestLength = 1e-6;

// Forces, tensions and weights per metre [N, N/m], moments [N m]. The strongest rope carries 1e8 N.
inline constexpr double kLargestForce = 1e12;

// Axial stiffness [N], if it is not infinite. A thread of rubber of twenty micrometres has 3e-4 N, a bar of steel of
// eighty metres 1e15 N. Under forces of newtons a softer cable would be stretched by more than its length's
// thousandfold.
inline constexpr double kLeastAxialStiffness = 2e-4;
inline constexpr double kLargestAxialStiffness = 1e18;

// Bending stiffness [N m^2], if it is not zero. Spider silk has 1e-14, a bar of steel of a hundred metres 1e18.
inline constexpr double kLeastBendingStiffness = 1e-24;
inline constexpr double kLargestBendingStiffness = 1e20;

// Weight per metre [N/m] of a cable, if it is not zero: a single chain of carbon atoms weighs 1e-12 on the Earth.
// Weight of a platform [N]: a grain of pollen weighs 1e-10. The largest is kLargestForce.
inline constexpr double kLeastWeight = 1e-18;

// Radius of a guide pulley [m], if there is one: that of a fibre's guide is 1e-5, the sheaves of an aerial tramway have
// 5. Way from the drum to the pulley [m].
inline constexpr double kLeastPulleyRadius = 1e-6;
inline constexpr double kLargestPulleyRadius = 1e3;
inline constexpr double kLargestDeadLength = 1e4;

// Acceleration of gravity [m/s^2]: that of a neutron star is 1e12, of an asteroid of some metres 1e-7.
inline constexpr double kLeastGravity = 1e-9;
inline constexpr double kLargestGravity = 1e6;

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

// How far one step of Newton's method may move a cable, whoever chooses the step.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {

// A node that turns farther leaves the range in which its segment's sensitivities say anything [rad].
inline constexpr double kMaxAngleStep = 0.7;

// Share of the cable's length. A longer change would move most cables from taut to slack or back in one step.
inline constexpr double kMaxLengthStep = 0.1;

// The forces of a taut cable at most double in one step: its sag goes with 1/T^2.
inline constexpr double kMaxForceStep = 1.0;

// Damping in (0, 1] by which a change of (H, V, L) alters the length by no more than it may.
inline double dampingByLength(const Eigen::Vector3d& change, double length) {
  return std::min(1.0, kMaxLengthStep * length / std::abs(change.z()));
}

// The same for the forces of a taut cable.
inline double dampingByForce(const Eigen::Vector3d& change, double tension) {
  return std::min(1.0, kMaxForceStep * tension / change.head<2>().norm());
}

}  // namespace cdpr_kinetostatics

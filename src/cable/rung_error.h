// What a rung of the ladder leaves out, for one cable: the estimate behind every estimated_error and behind AUTO.
//
// The estimate is that of the finest rung, BENDING, to leading order: at the same forces at A and the same
// unstrained length its end lies elsewhere by `end`; held at the same end, its forces differ by `force`. It
// costs about a microsecond. Conventions of docs/conventions.md; docs/theory.md section 4.
#pragma once

#include <Eigen/Core>
#include <array>

#include "cable/auto_policy.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"

namespace cdpr_kinetostatics {

struct RungError {
  Eigen::Vector2d end = Eigen::Vector2d::Zero();        // (x, y) [m]
  Eigen::Vector2d force = Eigen::Vector2d::Zero();      // (H, V) [N]
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  // d(H, V)/d(x, y) of the cable that hangs there [N/m]
  // The same as `end`, as a distance, and what is reported of a cable; but of a line between given ends, whose `end` is
  // that of the linear estimate which goes with `force`, it is evaluated under the line's forces [m].
  double displacement = 0.0;
  // False where the estimate is an order of magnitude at best: few bending layers in the length, sharp slack
  // bends, compression.
  bool known = true;
};

// Of a solved cable; EA and EI are those of the description, whatever the solution's rung saw of them.
RungError rungError(const CableProperties& cable, const CableSolution& solution);

// Of every rung that AUTO chooses from, at the forces of a catenary. Only BENDING is known unless H > 0.
using RungErrors = std::array<RungError, kAutoRungCount>;
RungErrors rungErrors(const CableProperties& cable, double length, double horizontal_force, double vertical_force_a);

}  // namespace cdpr_kinetostatics

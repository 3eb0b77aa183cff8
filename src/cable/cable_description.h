// What the descriptions of all kinds of cables have in common.
#pragma once

#include <Eigen/Core>

#include "cable/forces_at_a.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/end_point.h"

namespace cdpr_kinetostatics {

// A converged solution that knows length and forces, and no shape yet.
CableSolution solutionUnder(const CableProperties& cable, double length, const ForcesAtA& forces);

// d(H, V)/d(x, y, L) from the end point's Jacobian; zero where forces do not follow from the geometry.
Eigen::Matrix<double, 2, 3> forceJacobian(const EndPoint& end);

// Derivatives that do not exist (the compliance of a narrow loop is infinite) are reported as zero.
void zeroNonFinite(Eigen::Matrix<double, 2, 3>* jacobian);

}  // namespace cdpr_kinetostatics

// What the Jacobian of an adjustment says of its observations and its answer (docs/theory.md section 5).
#pragma once

#include "estimation/adjustment.h"

namespace cdpr_kinetostatics {

// Fills redundancies, weighted_squares, information and load_covariance, and drops observations of what is not known.
// jacobian: of all observations by (pose, densities), in units of their standard deviations; load: of the load's
// components by the same.
void analyse(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& load, Adjusted* adjusted);

}  // namespace cdpr_kinetostatics

// What the Jacobian of an adjustment says of its observations and its answer (docs/theory.md section 5).
#pragma once

#include "estimation/adjustment.h"

namespace cdpr_kinetostatics {

// Orthonormal basis of what the unknowns can explain of the observations.
Eigen::MatrixXd explainable(const Eigen::MatrixXd& jacobian);

// From the residuals and the Jacobian of all observations: fills redundancies, weighted_squares, information and
// load_covariance, and drops observations of what is not known. load: of the load's components by the Jacobian's
// columns.
void analyse(const Eigen::MatrixXd& load, Adjusted* adjusted);

}  // namespace cdpr_kinetostatics

// From solved forces to a full CableSolution: measures, Jacobians, profile. Shared by the single-cable
// problems and the robot's solvers.
#pragma once

#include "cable/multiple_shooting.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/end_point.h"

namespace cdpr_kinetostatics {

// The properties that the model sees: an infinite axial stiffness for the inextensible rungs, no bending
// stiffness where bending is left out.
CableProperties asSeenBy(Model model, const CableProperties& cable);

// d(H, V)/d(x, y, L) from the end point's Jacobian; zero where forces do not follow from the geometry.
Eigen::Matrix<double, 2, 3> forceJacobian(const EndPoint& end);

// Describes a straight or catenary cable under the forces (H, V) at A. For a straight cable without
// tension the end (x, y) says where it points.
CableSolution describeClosedForm(const CableProperties& cable, Model model, double length, double horizontal_force,
                                 double vertical_force_a, double x, double y, int profile_points);

// Describes the converged bending cable that shooting holds.
CableSolution describeBending(const CableProperties& cable, Model model, const MultipleShooting& shooting,
                              int profile_points);

}  // namespace cdpr_kinetostatics

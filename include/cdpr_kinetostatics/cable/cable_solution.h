// The answer to one of a cable's three problems, with its own evidence.
//
// Frame: the cable's vertical plane, A at the origin, x horizontal towards B, y upward; conventions
// of docs/conventions.md. The force at A is (H, V); the cable pulls its end B with (-H, V - q L).
//
// With a guide pulley A is the point A0 where the rope reaches it, L counts from there, and the free part of the cable,
// which alone has weight, begins where the rope leaves the pulley: the pull at B is (-H, V - q free_length).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/cable/report.h"

namespace cdpr_kinetostatics {

struct ProfilePoint {
  double s = 0.0;        // unstrained arc length along the free part [m]
  double x = 0.0;        // [m]
  double y = 0.0;        // [m]
  double alpha = 0.0;    // slope angle [rad]
  double moment = 0.0;   // M [N m]
  double tension = 0.0;  // tangential force T_alpha [N]
  double shear = 0.0;    // -S = -dM/dp [N]
};

struct CableSolution {
  Status status;
  Model model = Model::kDefault;

  double length = 0.0;            // L, unstrained, from A0 where there is a pulley [m]
  double free_length = 0.0;       // of it, what is not on the pulley, with what the dead part gives [m]
  double strained_length = 0.0;   // of the free part and of what is on the pulley [m]
  double x = 0.0;                 // end B [m]
  double y = 0.0;                 // end B [m]
  double horizontal_force = 0.0;  // H [N]
  double vertical_force_a = 0.0;  // V [N]
  double tension_a = 0.0;         // hypot(H, V) [N]
  double vertical_force_b = 0.0;  // V - q free_length: what lifts B [N]
  double tension_b = 0.0;         // hypot(H, V - q free_length) [N]
  double wrap_angle = 0.0;        // of the pulley that the rope is wrapped around [rad]
  double departure_x = 0.0;       // where the rope leaves the pulley, from A0 [m]
  double departure_y = 0.0;       // [m]
  double angle_a = 0.0;           // alpha(0), where the rope leaves [rad]
  double angle_b = 0.0;           // alpha(L) [rad]
  double sag = 0.0;               // largest distance of the free part from its chord, perpendicular to it [m]
  double max_moment = 0.0;        // largest |M|, on the pulley as well [N m]
  double max_shear = 0.0;         // largest |S| [N]

  // d(x, y)/d(H, V, L) of the end point, at equilibrium.
  Eigen::Matrix<double, 2, 3> end_jacobian = Eigen::Matrix<double, 2, 3>::Zero();
  // d(H, V)/d(x, y, L) of the forces; zero where forces do not follow from the geometry (STRAIGHT).
  Eigen::Matrix<double, 2, 3> force_jacobian = Eigen::Matrix<double, 2, 3>::Zero();

  double closure_residual = 0.0;  // distance of the computed end from the asked one [m]
  double moment_residual = 0.0;   // largest moment defect: at the free ends and between segments [N m]
  int iterations = 0;
  int integrator_steps = 0;      // of the bending rungs, tried: those that the step control refused included
  int evaluations = 0;           // of their right-hand side
  double estimated_error = 0.0;  // how far the finest rung's end lies from this one's at the same forces [m]
  bool error_known = false;      // the estimate is more than an order of magnitude
  double least_tension = 0.0;    // problem 3 that is INFEASIBLE: the least T_A that can hold the cable [N]

  std::vector<ProfilePoint> profile;  // the free part, uniform in s, both ends included; only if asked for
};

}  // namespace cdpr_kinetostatics

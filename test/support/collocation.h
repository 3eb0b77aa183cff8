// Verifies an equilibrium of the bending cable by means that share nothing with the package's shots: Gauss-Legendre
// collocation of order 12 of the boundary value problem (docs/theory.md (7), (8)) on a mesh graded towards bending
// layers and bends, Newton's method with exact derivatives on all unknowns at once, a banded LU factorisation, and the
// same on a finer mesh for an estimate of its own error. Stability is counted on a finite-element second variation.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"

namespace cdpr_kinetostatics {

// What somebody says is an equilibrium; Newton's method starts from it.
struct ClaimedCable {
  CableProperties cable;                // EI > 0
  double length = 0.0;                  // [m]
  double x = 0.0, y = 0.0;              // end B [m]
  double h = 0.0, v = 0.0;              // force at A [N]
  std::vector<ProfilePoint> profile{};  // uniform in s, if known; else the shape is guessed from the force
};

// What is kept: the end point, as in problem 2, or the forces, as in problem 1.
enum class Kept { kEndPoint, kForces };

struct VerifiedCable {
  bool converged = false;
  double h = 0.0, v = 0.0;              // [N]
  double x = 0.0, y = 0.0;              // [m]
  double angle_a = 0.0, angle_b = 0.0;  // [rad]
  double force_error = 0.0;             // estimated error of (h, v) [N]
  double end_error = 0.0;               // estimated error of (x, y) [m]
  bool stable = false;                  // with both ends held
  double area_below_chord = 0.0;        // [m^2]
  double turning = 0.0;                 // alpha(L) - alpha(0) [rad]
  Eigen::Matrix2d compliance;           // d(x, y)/d(h, v) [m/N]
  int iterations = 0;
  int intervals = 0;

  // Stable, below its chord, without loops: the equilibrium that is asked for.
  bool sags() const;
};

VerifiedCable verify(const ClaimedCable& claim, Kept kept);

}  // namespace cdpr_kinetostatics

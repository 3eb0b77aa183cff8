// A cable in closed form that comes from a guide pulley or has a dead part behind it: the straight and the catenary
// models, and those that bend where EI = 0. The pulley-less kinds do not know of either.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "cable/closed_form_cable.h"
#include "cable/pulley_end.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

class PulleyCable : public ClosedFormCable {
 public:
  PulleyCable() = default;
  PulleyCable(const CableProperties& cable, FreeShape shape) : ClosedFormCable(cable), shape_(shape) {}

  SolveOutcome startUnder(double length, const ForcesAtA& forces, const SolveLimits& limits);

  // By Newton's method. It starts from the hinged cable that hangs from where a straight rope would leave the pulley.
  SolveOutcome startBetween(double length, double x, double y, const SolveLimits& limits);
  SolveOutcome followBetween(double length, double x, double y, const SolveLimits& limits) {
    return startBetween(length, x, y, limits);
  }

  // Those of the straight cable and of the string, between the point where a straight rope leaves the pulley and B.
  SolveOutcome startWithTension(double x, double y, double tension_a, double* least_tension);
  bool lengthIsChord(double x, double y, double tension_a, double length_hint) const;
  double longestLength(double way, double tension_a) const;

  bool linearise(bool adapt);
  void step(const Eigen::Vector3d& change, double damping);
  void follow(const Eigen::Vector3d& change) { step(change, 1.0); }
  double freeLength() const { return at_.free_length; }
  const Eigen::RowVector3d& freeLengthDerivative() const { return at_.free_length_by; }

  // Without tension (x, y) says where a line points.
  CableSolution describe(double x, double y, int profile_points) const;

 private:
  Status contact() const;
  void startLine(double length, double angle, double tension);
  SolveOutcome stretchLine(double length, double x, double y);
  ForcesAtA roughForces(double length, double x, double y) const;
  SolveOutcome closeEnd(double x, double y);

  FreeShape shape_ = FreeShape::kCatenary;
  PulleyEnd at_;
};

// Problem 2 of the catenary for those to whom it is a start: its forces, if it has any. A pulley moves the end of a
// cable that bends by so much that the corrected catenary is the better start.
std::optional<ForcesAtA> hangingForces(const CableProperties& cable, double length, double x, double y);

// Why no cable that bends lies on its pulley between these ends, INFEASIBLE, judged on the corrected catenary;
// CONVERGED where that does not say so.
Status pulleyRefusal(const CableProperties& cable, double length, double x, double y);

}  // namespace cdpr_kinetostatics

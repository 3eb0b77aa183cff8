// The cable that bends: BENDING_INEXTENSIBLE and BENDING where EI > 0, by multiple shooting.
//
// One Newton step of its nodes is taken in each linearisation, so that nodes, forces and pose converge together.
#pragma once

#include <Eigen/Core>

#include "cable/bending.h"
#include "cable/forces_at_a.h"
#include "cable/length_search.h"
#include "cable/multiple_shooting.h"
#include "cable/solve_outcome.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/end_point.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

class BendingCable {
 public:
  // Problem 3 starts from the length of the catenary that has nearly the same tension: every sample of T_A(L) is a
  // solve, and bending lowers the tension only a little.
  static constexpr bool kStartsFromCatenary = true;

  // tolerance is that of the integration, relative.
  BendingCable(const CableProperties& cable, double tolerance) : properties_(cable), tolerance_(tolerance) {}

  const CableProperties& properties() const { return properties_; }
  ForcesAtA forces() const { return {shooting_.horizontalForce(), shooting_.verticalForceA()}; }
  double length() const { return shooting_.length(); }
  const EndPoint& end() const { return shooting_.end(); }
  double freeLength() const { return shooting_.freeLength(); }
  Eigen::RowVector3d freeLengthDerivative() const { return shooting_.freeLengthDerivative(); }

  void start(double length, const ForcesAtA& forces);
  SolveOutcome startUnder(double length, const ForcesAtA& forces, const SolveLimits& limits);
  SolveOutcome startBetween(double length, double x, double y, const SolveLimits& limits);
  // Newton's method from the equilibrium that the cable holds; where that fails, from the catenary.
  SolveOutcome followBetween(double length, double x, double y, const SolveLimits& limits);

  bool lengthIsChord(double x, double y, double tension_a, double length_hint) const {
    return isString(properties_, x, y, tension_a, length_hint);
  }
  double longestLength(double chord, double tension_a) const {
    return longestSagging(properties_.weight, chord, tension_a);
  }

  bool linearise(bool adapt, SolveLimits::Clock::time_point deadline) { return shooting_.linearise(adapt, deadline); }
  double dampingFor(const Eigen::Vector3d& change) const;
  double angleChange(const Eigen::Vector3d& change) const { return shooting_.angleChange(change); }
  void step(const Eigen::Vector3d& change, double damping) { shooting_.step(change, damping); }
  void follow(const Eigen::Vector3d& change) { shooting_.follow(change); }
  bool stepsFit() { return shooting_.stepsFit(); }
  bool onBranch() const { return onSaggingBranch(shooting_); }
  IntegrationWork work() const { return shooting_.work(); }

  CableSolution describe(double x, double y, int profile_points) const;

 private:
  CableProperties properties_;
  double tolerance_;
  MultipleShooting shooting_;  // holds (H, V, L) besides its nodes
};

}  // namespace cdpr_kinetostatics

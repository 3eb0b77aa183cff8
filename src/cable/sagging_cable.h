// One cable of any model: under forces (H, V) at A and with length L, where does it end, to first order in changes of
// (H, V, L)? What robots, the estimator and the three problems of a cable hold, each a copy of its own to write to.
//
// Behind it stands one kind of cable, a class of two files, chosen once, by the factory in sagging_cable.cpp: that is
// the only place that asks which model it is. Each kind holds its own (H, V, L), once, and has the members that are
// listed here; what makes it different (a line has no shape of its own, an inextensible string no length but its chord,
// only bending stiffness carries compression) is its own business. A copy of a cable to one of the same kind takes
// nothing from the heap that the other does not have already.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "cable/bending_cable.h"
#include "cable/catenary_cable.h"
#include "cable/corrected_catenary_cable.h"
#include "cable/forces_at_a.h"
#include "cable/pulley_cable.h"
#include "cable/solve_outcome.h"
#include "cable/straight_cable.h"
#include "cable/tautness.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/end_point.h"
#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

// The properties that the model sees: an infinite axial stiffness for the inextensible models, no bending stiffness
// where bending is left out.
CableProperties asSeenBy(Model model, const CableProperties& cable);

class SaggingCable {
 public:
  SaggingCable() = default;
  SaggingCable(const CableProperties& cable, Model model, double tolerance);

  // Starts the shape from the catenary under these forces. The cable must be under tension.
  void start(double length, const ForcesAtA& forces);

  // Problem 1, from nothing: starts from the equilibrium under the given forces.
  SolveOutcome startUnder(double length, const ForcesAtA& forces, const SolveLimits& limits);

  // Problem 2, from nothing: starts from the equilibrium between the given ends, on the sagging branch.
  SolveOutcome startBetween(double length, double x, double y, const SolveLimits& limits);
  // The same from the equilibrium that the cable holds already, to an end and a length nearby.
  SolveOutcome followBetween(double length, double x, double y, const SolveLimits& limits);

  // What problem 3 asks of a kind: whether its length is its chord whatever the tension, from which length on it is
  // followed, and up to where.
  bool lengthIsChord(double x, double y, double tension_a, double length_hint) const;
  bool startsFromCatenary() const;
  double longestLength(double chord, double tension_a) const;

  // adapt: choose integration steps anew. False: the cable cannot be evaluated here, or not before the deadline.
  bool linearise(bool adapt, SolveLimits::Clock::time_point deadline = SolveLimits::Clock::time_point::max());
  const EndPoint& end() const;

  // Damping that keeps the next step within reach of Newton's method, in (0, 1].
  double dampingFor(const Eigen::Vector3d& change) const;
  // Largest change of an angle along the cable that step() would make [rad].
  double angleChange(const Eigen::Vector3d& change) const;

  // Moves (H, V, L) by damping * change, and the nodes with them.
  void step(const Eigen::Vector3d& change, double damping);

  // Moves (H, V, L) by change, along the equilibria: the nodes' own Newton step has been taken before.
  void follow(const Eigen::Vector3d& change);

  // False where the integration steps chosen last no longer suit the cable: linearise(true) is due.
  bool stepsFit();

  // True if the equilibrium is the sagging, stable one.
  bool onBranch() const;
  bool pushes() const { return cdpr_kinetostatics::pushes(forces()); }

  ForcesAtA forces() const;
  double horizontalForce() const { return forces().horizontal; }
  double verticalForceA() const { return forces().vertical; }
  double tensionA() const { return forces().tension(); }
  // V - q times the free length: with what the cable lifts its end B [N]; and its derivative by (H, V, L). Of the
  // last linearise().
  double verticalForceB() const;
  Eigen::RowVector3d verticalForceBDerivative() const;
  double length() const;
  // Unstrained length of the part that hangs freely, and has weight.
  double freeLength() const;
  const CableProperties& properties() const;
  Model model() const { return model_; }
  // All integration so far.
  IntegrationWork work() const;
  // True if the shape is integrated, not a closed form.
  bool bends() const { return std::holds_alternative<BendingCable>(kind_); }

  // The converged cable with all its measures; (x, y) is the end asked for.
  CableSolution describe(double x, double y, int profile_points) const;

 private:
  using Kind = std::variant<StraightCable, CatenaryCable, CorrectedCatenaryCable, BendingCable, PulleyCable>;

  static Kind kindOf(const CableProperties& seen, Model model, double tolerance);

  Model model_ = Model::kDefault;
  Kind kind_;
};

}  // namespace cdpr_kinetostatics

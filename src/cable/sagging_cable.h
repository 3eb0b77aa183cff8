// One cable of any rung as the coupled solvers of the robot see it: under forces (H, V) at A and with length
// L, where does it end, to first order in changes of (H, V, L)?
//
// Catenaries and straight lines answer in closed form. A bending cable takes one Newton step of its nodes
// per linearisation, so that nodes, forces and pose converge together. A workspace: one per cable and solve.
#pragma once

#include "cable/bending.h"
#include "cable/multiple_shooting.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/end_point.h"
#include "cdpr_kinetostatics/cable/model.h"

namespace cdpr_kinetostatics {

class SaggingCable {
 public:
  SaggingCable() = default;
  SaggingCable(const CableProperties& cable, Model model, double tolerance);

  // Starts the shape from the catenary under these forces. The cable must be under tension.
  void start(double length, const ForcesAtA& forces);

  // Starts from the equilibrium between the given ends: problem 2, on the sagging branch.
  Status startBetween(double length, double x, double y, const SolveLimits& options);

  // adapt: choose integration steps anew. False: the cable cannot be evaluated here.
  bool linearise(bool adapt);
  const EndPoint& end() const { return end_; }

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
  bool pushes() const { return forces_.push(); }

  double horizontalForce() const { return forces_.horizontal; }
  double verticalForceA() const { return forces_.vertical; }
  double length() const { return length_; }
  double tensionA() const;
  const CableProperties& properties() const { return seen_; }
  Model model() const { return model_; }

  // The converged cable with all its measures; (x, y) is the end asked for.
  CableSolution describe(double x, double y, int profile_points) const;

 private:
  bool bends() const { return isBending(model_) && seen_.bending_stiffness > 0.0; }

  CableProperties seen_;
  Model model_ = Model::kBending;
  double tolerance_ = 1e-8;
  double length_ = 0.0;
  ForcesAtA forces_;
  EndPoint end_;
  MultipleShooting shooting_;
};

}  // namespace cdpr_kinetostatics

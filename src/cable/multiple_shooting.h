// The bending cable as a chain of shots, with its node states eliminated (docs/theory.md section 3).
//
// A single shot over the whole cable amplifies errors by exp(kappa L). Here the cable is cut into segments
// (shooting_mesh.h), and Newton's method joins them. Each pass evaluates every segment once and eliminates the nodes
// (shooting_chain.h), which leaves, for the outer problem, the end point as an affine function of the changes of (H, V,
// L). A guide pulley at A, and what stretches behind it, are part of that (chain_on_pulley.h). Whoever chooses those
// changes (one cable, a robot, an estimator) calls step() with them, and the nodes follow: nodes, forces and pose
// converge together. What the cable then looks like, shape_measures.h says.
//
// A workspace: keep one per cable and thread; after its first use it does not allocate for cables of the
// same size.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "cable/chain_on_pulley.h"
#include "cable/forces_at_a.h"
#include "cable/rope_on_pulley.h"
#include "cable/segmented_cable.h"
#include "cable/shooting_chain.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/end_point.h"
#include "cdpr_kinetostatics/cable/report.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {

class MultipleShooting {
 public:
  // Meshes the cable and starts its nodes from the catenary under the forces (H, V) [N] at A, with the
  // bending layers at both ends. Needs EI > 0, T > 0 along the cable; an infinite EA is the inextensible
  // cable. tolerance is relative, of the integration.
  void start(const CableProperties& cable, double length, double horizontal_force, double vertical_force_a,
             double tolerance, Middle middle = Middle::kQuiet);

  // The same from the straight line to (x, y), under the force that stretches or compresses it to that length; the
  // whole cable is shot. Needs a finite EA.
  void startStraight(const CableProperties& cable, double length, double x, double y, double tolerance);

  // The same from a straight line in this direction [rad], under any forces.
  void startAlong(const CableProperties& cable, double length, const ForcesAtA& forces, double angle, double tolerance);

  // The same by a single shot from A with the angle given there, for cables of a few bending layers. Returns the
  // moment left at B, in units of the bending layers' own; empty if the shot was rejected.
  std::optional<double> startFromAngle(const CableProperties& cable, double length, double horizontal_force,
                                       double vertical_force_a, double angle, double tolerance,
                                       SolveLimits::Clock::time_point deadline);

  // The same nodes for a cable of other properties: shape (angles, curvatures) and forces are kept. A cable without a
  // sharp bend is shot whole from now on, from the catenary if it was not before.
  void changeProperties(const CableProperties& cable);

  // Evaluates all segments and eliminates the nodes. With adapt, step sizes are chosen anew, and segments too
  // where they no longer fit the forces; without, those of the last adaptive pass are taken. False: a shot was
  // rejected, or the cable has more bending layers than segments can be afforded.
  //
  // One pass over a cable of many segments or under absurd forces can take a second: it is given up, false, where it
  // passes the deadline.
  bool linearise(bool adapt, SolveLimits::Clock::time_point deadline = SolveLimits::Clock::time_point::max());

  // The end point after the nodes' own Newton step, and its derivative, to first order, (20).
  const EndPoint& end() const { return end_; }

  // Largest change of a node's angle [rad] that step() would make.
  double angleChange(const Eigen::Vector3d& change) const { return chain_.angleChange(factors(change)); }

  // Moves nodes and unknowns by damping times the Newton step that goes with change = (dH, dV, dL).
  void step(const Eigen::Vector3d& change, double damping);

  // Moves nodes and unknowns by change along the equilibria: by the derivatives of the last linearise() alone,
  // after whose step the nodes are taken to have converged. Counts work anew.
  void follow(const Eigen::Vector3d& change);

  // False if the steps of the last adaptive pass make larger errors here than they should, or the segments no longer
  // fit the forces: linearise(true) is due.
  bool stepsFit();

  // True if no small displacement of the cable with both ends held lowers its energy: the second variation
  // under constant end forces has as many negative directions as the end point's compliance, (22).
  bool stable() const;

  // True if no small displacement of the cable with only A held, B under its force, lowers its energy: n(A) = 0 in
  // (22).
  bool stableWithFreeEnd() const { return chain_.negativeDirections() == 0; }

  // Whether the pulley, if there is one, holds the cable (rope_on_pulley.h).
  Status contact() const;

  // Signed area between chord and cable [m^2], positive where the cable lies below its chord.
  double areaBelowChord() const;
  // By how much this may be negative, or larger, because the moment at a pulley bends the cable [m^2].
  double areaOfPulleyMoment() const;

  // alpha(L) - alpha(0) [rad].
  double turning() const { return shape_.last_node.x() - shape_.segments.front().node.x(); }

  // Largest moment defect between segments and at the ends [N m] at the last linearise().
  double momentDefect() const { return chain_.momentDefect() * shape_.cable.unit_moment; }

  // Fills the shape's measures (end point, angles, sag, largest moment and shear, strained length) and, for
  // at least two profile points, the profile. The nodes must have converged.
  void measure(int profile_points, CableSolution* solution) const;

  // L, and the part of it that hangs freely with its derivative by (H, V, L).
  double length() const { return length_; }
  double freeLength() const { return shape_.cable.length; }
  Eigen::RowVector3d freeLengthDerivative() const { return on_pulley_.freeLengthDerivative(); }
  const CableProperties& properties() const { return shape_.cable.properties; }
  ForcesAtA forces() const { return {horizontalForce(), verticalForceA()}; }
  double horizontalForce() const { return shape_.cable.force.x(); }
  double verticalForceA() const { return shape_.cable.force.y(); }
  // pi^2 EI/L^2 [N].
  double bucklingForce() const { return shape_.cable.bucklingForce(); }
  // More segments would be needed than can be afforded: linearise() refuses.
  bool tooManySegments() const;
  int segments() const { return static_cast<int>(shape_.segments.size()); }
  bool hasQuietMiddle() const { return shape_.mesh.hasQuietMiddle(); }
  // Integration steps of one pass.
  int steps() const;
  // All integration since construction or the last follow().
  const IntegrationWork& work() const { return work_; }
  // Goes back to an earlier state; the work done since stays counted.
  void restore(const MultipleShooting& earlier);

 private:
  void begin(const CableProperties& cable, double length, const Eigen::Vector2d& force,
             const ShootingAccuracy& accuracy, Middle middle);
  bool meshFits() { return shape_.mesh.fits(shape_.cable, accuracy_); }
  void placeSegments(Middle middle);
  void replaceMesh(Middle middle);
  Eigen::Matrix2d complianceAtB() const;
  bool integrate(bool adapt, SolveLimits::Clock::time_point deadline);
  // What the chain's columns are multiplied by for change = (dH, dV, dL): (1, dh, dv, dl). dl is that of the free part.
  Eigen::Vector4d factors(const Eigen::Vector3d& change) const;
  // The same, (dH, dV) and the free length's own change apart.
  Eigen::Vector4d factors(const Eigen::Vector2d& forces, double free_length) const;
  void move(const Eigen::Vector4d& factors, const Eigen::Vector2d& forces, double free_length);
  bool beginsAtEyelet() const { return cdpr_kinetostatics::beginsAtEyelet(shape_.cable.properties); }

  ShootingAccuracy accuracy_;
  SegmentedCable shape_;
  ShootingChain chain_;
  ChainOnPulley on_pulley_;
  double length_ = 0.0;  // L [m]
  EndPoint end_;
  double step_error_ = 0.0;  // largest of a step in the last pass, in shares of what it should be
  IntegrationWork work_;
};

}  // namespace cdpr_kinetostatics

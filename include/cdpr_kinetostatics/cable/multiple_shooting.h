// The bending cable as a chain of shots, with its node states eliminated (docs/theory.md section 3).
//
// A single shot over the whole cable amplifies errors by exp(kappa L). Here the cable is cut into segments
// a few bending layers long; Newton's method joins them. Each pass integrates every segment once and
// eliminates the nodes by orthogonal transformations, which leaves, for the outer problem, the end point as
// an affine function of the changes of (H, V, L). Whoever chooses those changes (one cable, a robot, an
// estimator) calls step() with them, and the nodes follow: nodes, forces and pose converge together.
//
// A workspace: keep one per cable and thread; after its first use it does not allocate for cables of the
// same size.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/end_point.h"
#include "cdpr_kinetostatics/cable/shot.h"

namespace cdpr_kinetostatics {

class MultipleShooting {
 public:
  // Meshes the cable and starts its nodes from the catenary under the forces (H, V) [N] at A, with the
  // bending layers at both ends. Needs EI > 0, T > 0 along the cable; an infinite EA is the inextensible
  // cable. tolerance is relative, of the integration.
  void start(const CableProperties& cable, double length, double horizontal_force, double vertical_force_a,
             double tolerance);

  // The same from the straight line to (x, w), under the force that stretches or compresses it to that length.
  // Needs a finite EA.
  void startStraight(const CableProperties& cable, double length, double x, double w, double tolerance);

  // The same by a single shot from A with the angle given there, for cables of a few bending layers. Returns the
  // moment left at B, in units of the bending layers' own; empty if the shot was rejected.
  std::optional<double> startFromAngle(const CableProperties& cable, double length, double horizontal_force,
                                       double vertical_force_a, double angle, double tolerance);

  // The same nodes for a cable of other properties: shape (angles, curvatures) and forces are kept.
  void changeProperties(const CableProperties& cable);

  // Integrates all segments and eliminates the nodes. With adapt, step sizes are chosen anew; without,
  // those of the last adaptive pass are taken. False: a shot was rejected, or the cable has more bending
  // layers than segments can be afforded.
  bool linearise(bool adapt);

  // The end point after the nodes' own Newton step, and its derivative, to first order.
  const EndPoint& end() const { return end_; }

  // Largest change of a node's angle [rad] that step() would make.
  double angleChange(const Eigen::Vector3d& change) const;

  // Moves nodes and unknowns by damping times the Newton step that goes with change = (dH, dV, dL).
  void step(const Eigen::Vector3d& change, double damping);

  // True if no small displacement of the cable with both ends held lowers its energy: the second variation
  // under constant end forces has as many negative directions as the end point's compliance (docs/theory.md (22)).
  bool stable() const;

  // Signed area between chord and cable [m^2], positive where the cable lies below its chord.
  double areaBelowChord() const;

  // alpha(L) - alpha(0) [rad].
  double turning() const { return last_node_.x() - segments_.front().node.x(); }

  // Largest moment defect between segments and at the free ends [N m] at the last linearise().
  double momentDefect() const { return moment_defect_ * reference_moment_; }
  // Largest angle defect between segments [rad] at the last linearise().
  double angleDefect() const { return angle_defect_; }

  // Fills the shape's measures (end point, angles, sag, largest moment and shear, strained length) and, for
  // at least two profile points, the profile. The nodes must have converged.
  void measure(int profile_points, CableSolution* solution) const;

  double length() const { return length_; }
  double horizontalForce() const { return force_.x(); }
  double verticalForceA() const { return force_.y(); }
  // pi^2 EI/L^2 [N].
  double bucklingForce() const;
  int segments() const { return static_cast<int>(segments_.size()); }

 private:
  // Affine in (1, dh, dv, dl), dimensionless.
  using Affine = Eigen::Matrix<double, 2, 4>;

  struct Segment {
    double begin = 0.0;  // fractions of the length
    double end = 0.0;
    Eigen::Vector2d node = Eigen::Vector2d::Zero();  // (alpha, moment) where the segment begins
    StepGrid grid;
    Shot shot;
    ShotState begin_derivative, end_derivative;
    // Elimination: triangle * dz_k + coupling * dz_(k+1) = right.
    Eigen::Matrix2d triangle, coupling;
    Affine right;
    Affine change;  // dz_k, after back substitution
  };

  void begin(const CableProperties& cable, double length, const Eigen::Vector2d& force, double tolerance);
  void placeSegments();
  void startNodes();
  void setReference();
  ShotParameters parameters() const;
  bool eliminate();
  Eigen::Vector2d nodeChange(const Affine& change, const Eigen::Vector3d& outer, double damping) const;

  CableProperties cable_;
  double tolerance_ = 1e-8;
  double length_ = 0.0;
  double grid_length_ = 0.0;                         // length at the last adaptive pass
  Eigen::Vector2d force_ = Eigen::Vector2d::Zero();  // (H, V) [N]
  double reference_force_ = 1.0;                     // F0 [N]
  double reference_length_ = 1.0;                    // l0 [m]
  double reference_moment_ = 1.0;                    // F0 l0 [N m]
  ShotTolerance shot_tolerance_;
  std::vector<Segment> segments_;
  Eigen::Vector2d last_node_ = Eigen::Vector2d::Zero();  // (alpha, moment) at B
  Affine last_change_ = Affine::Zero();
  EndPoint end_;
  double angle_defect_ = 0.0;
  double moment_defect_ = 0.0;
  int focal_points_ = 0;
};

}  // namespace cdpr_kinetostatics

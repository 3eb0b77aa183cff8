// The bending cable as a chain of shots, with its node states eliminated (docs/theory.md section 3).
//
// A single shot over the whole cable amplifies errors by exp(kappa L). Here the cable is cut into segments
// a few bending layers long; Newton's method joins them. Where the cable is many layers long only its ends are
// shot: the quiet middle between them is one segment, in closed form (slow_manifold.h), so that the cost does
// not grow with kappa L. A loop too sharp for that is shot at its bend, too, between two quiet legs. Each pass
// integrates every segment once and eliminates the nodes by orthogonal transformations, which leaves, for the outer
// problem, the end point as an affine function of the changes of (H, V, L). Whoever chooses those changes (one cable, a
// robot, an estimator) calls step() with them, and the nodes follow: nodes, forces and pose converge together.
//
// A workspace: keep one per cable and thread; after its first use it does not allocate for cables of the
// same size.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "cable/shot.h"
#include "cable/slow_manifold.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/end_point.h"

namespace cdpr_kinetostatics {

// How the cable between its two ends' bending layers is evaluated.
enum class Middle {
  kQuiet,  // in closed form, where the tolerance allows
  kShot,   // by shots
};

struct ShapeMeter;  // of shape_measures.cpp

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

  // The same by a single shot from A with the angle given there, for cables of a few bending layers. Returns the
  // moment left at B, in units of the bending layers' own; empty if the shot was rejected.
  std::optional<double> startFromAngle(const CableProperties& cable, double length, double horizontal_force,
                                       double vertical_force_a, double angle, double tolerance);

  // The same nodes for a cable of other properties: shape (angles, curvatures) and forces are kept. A cable without a
  // sharp bend is shot whole from now on, from the catenary if it was not before.
  void changeProperties(const CableProperties& cable);

  // Integrates all segments and eliminates the nodes. With adapt, step sizes are chosen anew, and segments too
  // where they no longer fit the forces; without, those of the last adaptive pass are taken. False: a shot was
  // rejected, or the cable has more bending layers than segments can be afforded.
  bool linearise(bool adapt);

  // The end point after the nodes' own Newton step, and its derivative, to first order.
  const EndPoint& end() const { return end_; }

  // Largest change of a node's angle [rad] that step() would make.
  double angleChange(const Eigen::Vector3d& change) const;

  // Moves nodes and unknowns by damping times the Newton step that goes with change = (dH, dV, dL).
  void step(const Eigen::Vector3d& change, double damping);

  // Moves nodes and unknowns by change along the equilibria: by the derivatives of the last linearise() alone,
  // after whose step the nodes are taken to have converged.
  // Counts work anew.
  void follow(const Eigen::Vector3d& change);

  // False if the steps of the last adaptive pass make larger errors here than they should, or the segments no longer
  // fit the forces: linearise(true) is due.
  bool stepsFit();

  // True if no small displacement of the cable with both ends held lowers its energy: the second variation
  // under constant end forces has as many negative directions as the end point's compliance (docs/theory.md (22)).
  bool stable() const;

  // Signed area between chord and cable [m^2], positive where the cable lies below its chord.
  double areaBelowChord() const;

  // alpha(L) - alpha(0) [rad].
  double turning() const { return last_node_.x() - segments_.front().node.x(); }

  // Largest moment defect between segments and at the free ends [N m] at the last linearise().
  double momentDefect() const { return moment_defect_ * reference_moment_; }

  // Fills the shape's measures (end point, angles, sag, largest moment and shear, strained length) and, for
  // at least two profile points, the profile. The nodes must have converged.
  void measure(int profile_points, CableSolution* solution) const;

  double length() const { return length_; }
  double horizontalForce() const { return force_.x(); }
  double verticalForceA() const { return force_.y(); }
  // More segments would be needed than can be afforded: linearise() refuses.
  bool tooManySegments() const { return segments() > kMaxSegments; }
  // pi^2 EI/L^2 [N].
  double bucklingForce() const;
  int segments() const { return static_cast<int>(segments_.size()); }
  bool hasQuietMiddle() const { return slow_order_ > 0; }
  // A bend that is shot parts the quiet middle from an end, or in two.
  bool hasShotBend() const { return shot_bend_; }
  // Integration steps of one pass.
  int steps() const {
    std::size_t sum = 0;
    for (const Segment& segment : segments_) sum += segment.grid.size();
    return static_cast<int>(sum);
  }
  // All integration since construction or the last follow().
  const IntegrationWork& work() const { return work_; }
  // Goes back to an earlier state; the work done since stays counted.
  void restore(const MultipleShooting& earlier);

 private:
  // Affine in (1, dh, dv, dl), dimensionless.
  using Affine = Eigen::Matrix<double, 2, 4>;

  struct Segment {
    bool quiet = false;  // no shot, and its own end's node is apart from its beginning's
    double begin = 0.0;  // fractions of the length
    double end = 0.0;
    Eigen::Vector2d node = Eigen::Vector2d::Zero();  // (alpha, moment) where the segment begins
    StepGrid grid;
    Shot shot;
    SlowState slow_begin, slow_end;  // if quiet
    SlowStretch slow_stretch;
    ShotState begin_derivative, end_derivative;
    // Elimination: triangle * dz_k + coupling * dz_(k+1) = right.
    Eigen::Matrix2d triangle, coupling;
    Affine right;
    Affine change;  // dz_k, after back substitution
  };

  // One linear condition on the change of a node: row * dz = right.
  struct Condition {
    Eigen::RowVector2d row;
    Eigen::RowVector4d right;
  };

  // More segments than this are refused: a cable that is solved at all needs some tens of them, and a start that asks
  // for so many has lost its way.
  static constexpr int kMaxSegments = 1000;

  void begin(const CableProperties& cable, double length, const Eigen::Vector2d& force, double tolerance,
             double angle_scale, Middle middle);

  // Segments and their first nodes (shooting_mesh.cpp).
  void placeSegments(Middle middle);
  void setSegmentCount(std::size_t count);
  bool placeAroundMiddle();
  void placeEverywhere();
  void startNodes();
  bool meshFits();
  bool middleFits();
  void replaceMesh(Middle middle);

  // The same for a cable with a sharp bend, shot between two quiet legs (bend_mesh.cpp).
  bool placeAroundBend();
  void appendSegment(double begin, double end, bool quiet);
  void shootBetween(double t_from, double t_to);
  bool bendFits();
  void keepShape(const MultipleShooting& before);
  Eigen::Vector2d stateAt(double share) const;

  void setReference();
  ShotParameters parameters() const;
  bool integrate(bool adapt);
  void evaluateMiddle(std::size_t k);
  void evaluateModes(std::size_t k);
  static Eigen::Vector4d lengthDerivative(const Segment& segment);
  bool eliminate();
  Condition joinShot(const Condition& at_begin, const Eigen::Vector2d& next, Segment* segment);
  Condition joinMiddle(const Condition& at_begin, const Eigen::Vector2d& next, Segment* segment);
  // Walks along the middle in pieces small enough for cubic interpolation: visit(t, state, dt, next state).
  template <typename Visit>
  void forEachPiece(const Segment& middle, ShotState from, const Visit& visit) const;
  double whereSlopeIs(const Segment& middle, double angle) const;
  std::array<double, 2> whereTailsTurn(const Segment& middle) const;
  // Walk along a segment from its beginning and return the state at its end.
  ShotState measureMiddle(const Segment& segment, const ShotState& begin, ShapeMeter* meter) const;
  ShotState measureShot(const Segment& segment, ShotState state, ShapeMeter* meter, IntegrationWork* work) const;
  ShotState middleState(const Segment& middle, double t_from, const ShotState& from, double t) const;
  Affine displacement(const Segment& segment, const Affine& next_change) const;
  Eigen::Vector2d node(std::size_t k) const { return k < segments_.size() ? segments_[k].node : last_node_; }
  // (1, dh, dv, dl)
  Eigen::Vector4d factors(const Eigen::Vector3d& change) const;
  void move(const Eigen::Vector4d& factors, const Eigen::Vector3d& change);

  CableProperties cable_;
  double tolerance_ = 1e-8;
  double length_ = 0.0;
  double grid_length_ = 0.0;                         // length at the last adaptive pass
  Eigen::Vector2d force_ = Eigen::Vector2d::Zero();  // (H, V) [N]
  double reference_force_ = 1.0;                     // F0 [N]
  double reference_length_ = 1.0;                    // l0 [m]
  double reference_moment_ = 1.0;                    // F0 l0 [N m]
  ShotTolerance shot_tolerance_;
  std::vector<Segment> segments_, spare_segments_;
  int slow_order_ = 0;  // of the quiet segments; 0: none
  bool shot_bend_ = false;
  Eigen::Vector2d last_node_ = Eigen::Vector2d::Zero();  // (alpha, moment) at B
  Affine last_change_ = Affine::Zero();
  EndPoint end_;
  double step_error_ = 0.0;  // largest of a step, in shares of what it should be
  double moment_defect_ = 0.0;
  Eigen::Vector2d variation_ = Eigen::Vector2d::Zero();  // of (alpha, moment), from a turn of the end A
  int focal_points_ = 0;
  IntegrationWork work_;
};

}  // namespace cdpr_kinetostatics

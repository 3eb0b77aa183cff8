// The chain of a bending cable's segments: joins them and eliminates their nodes (docs/theory.md section 3, "Multiple
// shooting, nodes eliminated").
//
// It takes segments with their sensitivities and does not ask where they come from. What it returns is affine in (1,
// dh, dv, dl), the changes of the force at A and of the length in the units of shot.h.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cable/shooting_segment.h"

namespace cdpr_kinetostatics {

// What holds the cable's ends, in the unit of shot.h: no moment where they turn freely, (8). Where the cable leaves a
// pulley it has the pulley's curvature, and slides along it when it moves.
struct EndMoments {
  double a = 0.0;
  double b = 0.0;
  bool slides_at_a = false;
};

class ShootingChain {
 public:
  // Two rows, affine in (1, dh, dv, dl).
  using Affine = Eigen::Matrix<double, 2, 4>;

  // Solves (19) for the nodes' changes. last_node is (alpha, moment) at B. False where the equations are singular.
  bool eliminate(const SegmentList& segments, const Eigen::Vector2d& last_node, const EndMoments& moments);

  // (x, y) of B after the nodes' own Newton step, (20) without units.
  const Affine& end() const { return end_; }

  // Change of node k by Newton's step; the node after the last segment is that at B.
  const Affine& change(std::size_t k) const { return k < links_.size() ? links_[k].change : last_change_; }

  // The largest change of a node's angle [rad] for these (1, dh, dv, dl).
  double angleChange(const Eigen::Vector4d& factors) const;

  // Largest defect of the moment between segments and at the ends at the last elimination.
  double momentDefect() const { return moment_defect_; }

  // n(A) of (22): negative directions of the second variation (21) under dead forces at B, both ends free to turn, or A
  // free to slide along its pulley.
  int negativeDirections() const { return focal_points_; }

 private:
  // What elimination keeps of segment k: triangle * dz_k + coupling * dz_(k+1) = right.
  struct Link {
    Eigen::Matrix2d triangle, coupling;
    Affine right;
    Affine change;  // dz_k, after back substitution
  };

  // One linear condition on the change of a node: row * dz = right.
  struct Condition {
    Eigen::RowVector2d row;
    Eigen::RowVector4d right;
  };

  Condition joinShot(const Condition& at_begin, const ShootingSegment& segment, const Eigen::Vector2d& next,
                     Link* link);
  Condition joinQuiet(const Condition& at_begin, const ShootingSegment& segment, const Eigen::Vector2d& next,
                      Link* link);
  Condition modeIsAbsent(const SlowState& slow, double rho, double share, const Eigen::Vector2d& node);
  void countFocalPoints(const ShootingSegment& shot);
  bool substituteBack(const SegmentList& segments);

  std::vector<Link> links_;
  Affine last_change_ = Affine::Zero();  // of the node at B
  Affine end_ = Affine::Zero();
  double moment_defect_ = 0.0;
  // The change of (alpha, moment) that follows from a turn of the end A, or from a change of its moment where a pulley
  // does not let it turn, up to a positive factor, and its zeros so far.
  Eigen::Vector2d variation_ = Eigen::Vector2d::Zero();
  int focal_points_ = 0;
};

}  // namespace cdpr_kinetostatics

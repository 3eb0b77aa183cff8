// A bending cable cut into segments: its nodes, and what lies between them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cable/shooting_mesh.h"
#include "cable/shooting_segment.h"
#include "cable/shot_cable.h"

namespace cdpr_kinetostatics {

// The chain (shooting_chain.h) joins its segments, measures (shape_measures.h) are read off it once they are joined.
struct SegmentedCable {
  ShotCable cable;
  ShootingMesh mesh;
  SegmentList segments;                                 // one for each interval of the mesh
  Eigen::Vector2d last_node = Eigen::Vector2d::Zero();  // (alpha, moment) at B
  double grid_length = 0.0;                             // the cable's length when the segments' steps were chosen [m]

  Eigen::Vector2d node(std::size_t k) const { return k < segments.size() ? segments[k].node : last_node; }
  // What the steps chosen last are multiplied by at the cable's present length.
  double gridScale() const { return cable.length / grid_length; }
  // The segment's first state, with (x, y) counted from there.
  static ShotState beginOf(const ShootingSegment& segment) { return {segment.node.x(), segment.node.y(), 0.0, 0.0}; }
  // (alpha, moment) at a share of the length: the cubics through the ends of shots, the closed form elsewhere.
  Eigen::Vector2d stateAt(double share) const;
  // State at t within a quiet segment: its solution without layers and what is left there of the modes at both of its
  // ends. (x, y) are counted on from the state `from` at t_from, in the same segment.
  ShotState quietStateAt(const ShootingSegment& segment, double t_from, const ShotState& from, double t) const;

  // Makes one segment for each interval of the mesh, without nodes or steps yet.
  void layOutSegments();
  // Nodes on the catenary under the cable's forces with the bending layers of its two ends, (18), or (45) at a pulley.
  // Needs T > 0.
  void startOnCatenary();
  // The solution without layers at the ends of quiet segment k, and the node behind it: due after nodes or forces
  // moved.
  void evaluateQuietEnds(std::size_t k);
  void evaluateAllQuietEnds();
  // The same and (x, y) with its derivatives.
  void evaluateQuietSegment(std::size_t k);
};

}  // namespace cdpr_kinetostatics

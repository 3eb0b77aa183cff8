// The segments of a bending cable's chain: what integration, or the closed form, says of each.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cable/shot.h"
#include "cable/slow_manifold.h"

namespace cdpr_kinetostatics {

// Units of shot.h.
struct ShootingSegment {
  double begin = 0.0;  // as shares of the cable's length, which they stay when it changes
  double end = 0.0;
  bool quiet = false;                              // not shot; the node at its end is apart from the node at its begin
  Eigen::Vector2d node = Eigen::Vector2d::Zero();  // (alpha, moment) where it begins

  // Of a shot segment: what one shot from its node gave. Of a quiet one shot.end is (alpha, moment) of the next node,
  // and (x, y) that it leads to from its own begin.
  Shot shot;
  StepGrid grid;                               // the steps that were chosen last
  ShotState begin_derivative, end_derivative;  // d/dt at both ends

  // Of a quiet segment: the solution without layers at both ends, and what it adds to (x, y).
  SlowState slow_begin, slow_end;
  SlowStretch slow_stretch;
};

// Segments in their order from A to B. Those that fall away are kept with their buffers, so that a mesh that changes
// takes nothing from the heap.
class SegmentList {
 public:
  void resize(std::size_t count) {
    while (store_.size() < count) {
      ShootingSegment& segment = store_.emplace_back();
      segment.grid.reserve(kUsualSteps);
      segment.shot.turning.reserve(kUsualSteps);
    }
    count_ = count;
  }

  std::size_t size() const { return count_; }
  ShootingSegment& operator[](std::size_t k) { return store_[k]; }
  const ShootingSegment& operator[](std::size_t k) const { return store_[k]; }
  ShootingSegment& front() { return store_.front(); }
  const ShootingSegment& front() const { return store_.front(); }
  ShootingSegment* begin() { return store_.data(); }
  ShootingSegment* end() { return store_.data() + count_; }
  const ShootingSegment* begin() const { return store_.data(); }
  const ShootingSegment* end() const { return store_.data() + count_; }

 private:
  // Integration steps that a segment has room for at once: three layers take ten to thirty.
  static constexpr std::size_t kUsualSteps = 64;

  std::vector<ShootingSegment> store_;
  std::size_t count_ = 0;
};

}  // namespace cdpr_kinetostatics

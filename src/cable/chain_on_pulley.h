// A bending cable's chain of shots on its guide pulley, to first order, (44) of docs/theory.md.
//
// The chain knows the length of the free part; whoever owns (H, V, L) does not. How the free length follows from (H, V,
// L) depends on the slope at which the rope leaves the pulley, which is the chain's own first node.
#pragma once

#include <Eigen/Core>

#include "cable/segmented_cable.h"
#include "cable/shooting_chain.h"
#include "cdpr_kinetostatics/cable/end_point.h"

namespace cdpr_kinetostatics {

class ChainOnPulley {
 public:
  // Of an eyelet without dead part: the free length is L.
  void release() { free_by_ << 0.0, 0.0, 0.0, 1.0; }

  // After an elimination: `length` is L. False where a longer cable would not have a longer free part, or numbers
  // overflow.
  bool link(const SegmentedCable& shape, const ShootingChain& chain, double length);

  // End of the cable, from A0, after the nodes' and the free length's own Newton step.
  EndPoint end() const { return end_; }

  // Change of the free length by Newton's step that goes with (dH, dV, dL), and along the equilibria alone.
  double newtonChange(const Eigen::Vector3d& change) const { return free_by_[0] + followedChange(change); }
  double followedChange(const Eigen::Vector3d& change) const { return free_by_.tail<3>().dot(change); }

  // Derivative of the free length by (H, V, L).
  Eigen::RowVector3d freeLengthDerivative() const { return free_by_.tail<3>(); }

 private:
  Eigen::RowVector4d free_by_ = Eigen::RowVector4d::UnitW();  // affine in (1, dH, dV, dL)
  EndPoint end_;
};

}  // namespace cdpr_kinetostatics

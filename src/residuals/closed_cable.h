// A cable that is closed exactly: at a pose of the platform and a horizontal force density H/x, V and L follow from
// closure, equation (30), and so do their derivatives.
//
// H determines V and L uniquely and smoothly, also at the fold where the tension at A is least and a length could not
// be told from it. Blocks of measured lengths and tensions stand on this.
#pragma once

#include <Eigen/Core>

#include "cable/sagging_cable.h"
#include "geometry/cable_plane.h"

namespace cdpr_kinetostatics {

class ClosedCable {
 public:
  // anchor A [m], world; attachment b [m], platform frame; start: where the first search begins. Closed when
  // forces and the length change by less than the tolerance, relative; not tried after the deadline.
  ClosedCable(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment, const SaggingCable& start,
              const SolveLimits& limits);

  // density: H/x [N/m]. Starts from what it found last. False, and in no usable state, where nothing was found.
  bool close(const Pose& pose, double density);

  // As of the last success.
  const SaggingCable& cable() const { return cable_; }
  const CablePlane& plane() const { return plane_; }
  double density() const { return density_; }
  // d(H, V, L)/d(translation, rotation vector of the platform) at constant density, and d(H, V, L)/d(density).
  const Eigen::Matrix<double, 3, 6>& byPose() const { return by_pose_; }
  const Eigen::Vector3d& byDensity() const { return by_density_; }

  // The cable's force on the platform [N], (31), and its derivatives as above.
  Eigen::Vector3d force() const;
  Eigen::Matrix<double, 3, 6> forceByPose() const;
  Eigen::Vector3d forceByDensity() const;

 private:
  Eigen::Vector3d anchor_, attachment_;
  SolveLimits limits_;
  SaggingCable cable_;
  CablePlane plane_;
  double density_ = 0.0;
  Eigen::Matrix<double, 3, 6> by_pose_ = Eigen::Matrix<double, 3, 6>::Zero();
  Eigen::Vector3d by_density_ = Eigen::Vector3d::Zero();
  bool linearised_ = false;  // where it was closed last
};

}  // namespace cdpr_kinetostatics

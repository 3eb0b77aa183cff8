#include "residuals/closed_cable.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "cable/iteration_schedule.h"
#include "geometry/spatial.h"

namespace cdpr_kinetostatics {
namespace {

// From a state of a neighbouring pose Newton's method takes 2 to 4 iterations; one that takes this many is lost.
constexpr int kMaxIterations = 30;

}  // namespace

ClosedCable::ClosedCable(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment, const SaggingCable& start,
                         const SolveLimits& limits)
    : anchor_(anchor), attachment_(attachment), limits_(limits), cable_(start) {}

// Newton's method for (V, L), with the nodes of a bending cable. The first step takes the last linearisation.
bool ClosedCable::close(const Pose& pose, double density) {
  plane_ = cablePlane(anchor_, attachment_, pose);
  density_ = density;
  const double x = distanceBeside(plane_.x, cable_.length());
  bool adapt = !linearised_;
  for (int k = 0; k < kMaxIterations; ++k) {
    const bool fresh = k > 0 || !linearised_;
    if (fresh && !cable_.linearise(adapt, limits_.deadline)) return false;
    const Eigen::Matrix<double, 2, 3>& jacobian = cable_.end().jacobian;
    const Eigen::Matrix2d inverse = jacobian.rightCols<2>().inverse();
    Eigen::Vector3d change(density * x - cable_.horizontalForce(), 0.0, 0.0);
    const Eigen::Vector2d defect = Eigen::Vector2d(x, plane_.y) - cable_.end().position;
    change.tail<2>() = inverse * (defect - jacobian.col(0) * change.x());
    if (!change.allFinite()) return false;
    const double size = std::max({change.head<2>().norm() / cable_.tensionA(), std::abs(change.z()) / cable_.length(),
                                  cable_.angleChange(change)});
    cable_.step(change, std::min(1.0, cable_.dampingFor(change)));
    if (size <= limits_.tolerance && fresh && !adapt) {
      const Eigen::Matrix<double, 2, 6> end_by_pose = plane_.toPlane() * motionOfPoint(plane_.arm);
      by_pose_.row(0) = density * end_by_pose.row(0);
      by_pose_.bottomRows<2>() = inverse * (end_by_pose - jacobian.col(0) * by_pose_.row(0));
      by_density_ << x, -inverse * jacobian.col(0) * x;
      linearised_ = true;
      return true;
    }
    adapt = choosesStepsNext(size, k);
  }
  return false;
}

Eigen::Vector3d ClosedCable::force() const {
  return forceOnPlatform(plane_, cable_.horizontalForce(), cable_.verticalForceA(),
                         cable_.properties().weight * cable_.freeLength());
}

// Horizontally (33), vertically V less the weight of the free part.
Eigen::Matrix<double, 3, 6> ClosedCable::forceByPose() const {
  Eigen::Matrix<double, 3, 6> by_pose =
      Eigen::Vector3d(-density_, -density_, 0.0).asDiagonal() * motionOfPoint(plane_.arm);
  by_pose.row(2) = cable_.verticalForceBDerivative() * by_pose_;
  return by_pose;
}

Eigen::Vector3d ClosedCable::forceByDensity() const {
  const double vertical = cable_.verticalForceBDerivative().dot(by_density_);
  return -plane_.x * plane_.direction + vertical * Eigen::Vector3d::UnitZ();
}

}  // namespace cdpr_kinetostatics

#include "support/workspace_path.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {
namespace {

constexpr double kShareOfWorkspace = 0.4;

}  // namespace

Pose poseOnPath(const Workspace& workspace, double distance) {
  const Eigen::Vector3d half = kShareOfWorkspace * 0.5 * (workspace.high - workspace.low);
  const double radius = half.y() > 0.0 ? std::min(half.x(), half.y()) : half.x();
  const double angle = distance / radius;
  Pose pose;
  pose.position = 0.5 * (workspace.low + workspace.high);
  pose.position += Eigen::Vector3d(radius * std::cos(angle), half.y() > 0.0 ? radius * std::sin(angle) : 0.0,
                                   0.3 * std::min(radius, half.z()) * std::sin(2.0 * angle));
  return pose;
}

}  // namespace cdpr_kinetostatics

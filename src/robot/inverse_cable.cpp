#include "robot/inverse_cable.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {

bool InverseCable::linearise(const CableDescription& description, const Pose& pose, Steps steps) {
  const bool adapt = steps == Steps::kNew || (steps == Steps::kNewWhereDue && !cable.stepsFit());
  if (!cable.linearise(adapt)) return false;
  plane = cablePlane(description, pose);
  const double tension = cable.tensionA();
  // Three equations for (H, V, L): two of closure, and T_A dT_A = H dH + V dV.
  Eigen::Matrix3d system;
  system << cable.end().jacobian, cable.horizontalForce() / tension, cable.verticalForceA() / tension, 0.0;
  const Eigen::Matrix3d inverse = system.inverse();
  const Eigen::Vector2d defect = Eigen::Vector2d(plane.x, plane.y) - cable.end().position;
  open = defect.norm();
  by_end = inverse.leftCols<2>();
  start = by_end * defect;
  by_tension = inverse.col(2);
  by_turn = by_end * plane.toPlane() * -cross(plane.arm);
  return inverse.allFinite();
}

double InverseCable::size(const Eigen::Vector3d& change) const {
  return std::max(change.head<2>().norm() / cable.tensionA(), std::abs(change.z()) / cable.length());
}

Eigen::Vector3d InverseCable::force() const {
  return forceOnPlatform(plane, cable.horizontalForce(), cable.verticalForceA(),
                         cable.properties().weight * cable.length());
}

Eigen::Matrix3d InverseCable::forceByCable() const {
  Eigen::Matrix3d by_cable;
  by_cable << plane.forceByForces(), -cable.properties().weight * Eigen::Vector3d::UnitZ();
  return by_cable;
}

}  // namespace cdpr_kinetostatics

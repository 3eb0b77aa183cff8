#include "robot/robot_forces.h"

#include <algorithm>

#include "cable/sagging_cable.h"
#include "robot/platform_statics.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {

Residuals residualsOf(const RobotDescription& robot, const Wrench& external, Model model, const RobotForces& state) {
  Residuals residuals;
  Wrench total = loadWrench(robot, state.pose, external);
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot.cables[i], state.pose);
    const CableProperties& properties = robot.cables[i].properties;
    const double weight = properties.weight * freeLengthUnder(properties, state.lengths[i], state.forces[i]);
    total += wrenchAt(plane.arm, forceOnPlatform(plane, state.forces[i].horizontal, state.forces[i].vertical, weight));
    if (isBending(model)) continue;
    SaggingCable cable(properties, model, 0.0);
    cable.start(state.lengths[i], state.forces[i]);
    if (!cable.linearise(false)) continue;
    residuals.closure = std::max(residuals.closure, (cable.end().position - Eigen::Vector2d(plane.x, plane.y)).norm());
  }
  if (!total.allFinite()) return {};
  residuals.force = total.head<3>().norm();
  residuals.moment = robot.type == PlatformType::kPointMass ? 0.0 : total.tail<3>().norm();
  return residuals;
}

}  // namespace cdpr_kinetostatics

#include "robot/residual_blocks.h"

#include <vector>

namespace cdpr_kinetostatics {

PlatformEquilibrium::Platform platformOf(const RobotDescription& robot, const Wrench& external) {
  return {robot.type == PlatformType::kRigidBody, robot.weight(), robot.com, external};
}

std::unique_ptr<PlatformEquilibrium> equilibriumBlock(const RobotDescription& robot, const Wrench& external,
                                                      const Wrench& weight) {
  std::vector<PlatformEquilibrium::Cable> cables;
  for (const CableDescription& cable : robot.cables) {
    cables.push_back({cable.anchor, cable.attachment, cable.properties.weight});
  }
  return std::make_unique<PlatformEquilibrium>(platformOf(robot, external), cables, weight);
}

std::unique_ptr<CableClosure> closureBlock(const CableDescription& cable, Model model, double length_scale,
                                           const SolveLimits& limits) {
  return makeClosure(model, cable.properties, cable.anchor, cable.attachment, length_scale, limits);
}

}  // namespace cdpr_kinetostatics

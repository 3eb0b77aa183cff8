#include "robot/residual_blocks.h"

#include <vector>

namespace cdpr_kinetostatics {

std::unique_ptr<PlatformEquilibrium> equilibriumBlock(const RobotDescription& robot, const Wrench& external,
                                                      const Wrench& weight) {
  std::vector<PlatformEquilibrium::Cable> cables;
  for (const CableDescription& cable : robot.cables) {
    cables.push_back({cable.anchor, cable.attachment, cable.properties.weight});
  }
  const PlatformEquilibrium::Platform platform{robot.type == PlatformType::kRigidBody, robot.weight(), robot.com,
                                               external};
  return std::make_unique<PlatformEquilibrium>(platform, cables, weight);
}

std::unique_ptr<CableClosure> closureBlock(const CableDescription& cable, Model model, double length_scale,
                                           const SolveLimits& options) {
  return makeClosure(model, cable.properties, cable.anchor, cable.attachment, length_scale, options);
}

}  // namespace cdpr_kinetostatics

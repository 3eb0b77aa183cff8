// The residual blocks of a robot: from its description to the blocks of residuals/.
#pragma once

#include <memory>

#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/cable/solve_limits.h"
#include "cdpr_kinetostatics/residuals/cable_closure.h"
#include "cdpr_kinetostatics/residuals/platform_equilibrium.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// What the blocks know of the platform.
PlatformEquilibrium::Platform platformOf(const RobotDescription& robot, const Wrench& external);

// weight multiplies the unbalanced wrench [1/N, 1/(N m)].
std::unique_ptr<PlatformEquilibrium> equilibriumBlock(const RobotDescription& robot, const Wrench& external,
                                                      const Wrench& weight);

std::unique_ptr<CableClosure> closureBlock(const CableDescription& cable, Model model, double length_scale,
                                           const SolveLimits& limits);

}  // namespace cdpr_kinetostatics

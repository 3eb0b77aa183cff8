// Forward kinetostatics: unstrained cable lengths and the load give the platform's pose and the tensions.
//
// Works for any number of cables: over-, fully and under-constrained, rigid body or point mass
// (docs/theory.md section 5). The answer depends on the request alone.
#pragma once

#include <optional>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

struct ForwardRequest {
  std::vector<double> lengths;              // unstrained [m], in the robot's order
  Wrench external_wrench = Wrench::Zero();  // on the platform, without its weight
  std::optional<Pose> seed;                 // where to start; the robot's home if empty
};

RobotSolution solveForward(const RobotDescription& robot, const ForwardRequest& request,
                           const RobotSolverOptions& options);

}  // namespace cdpr_kinetostatics

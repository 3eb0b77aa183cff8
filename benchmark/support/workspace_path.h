// The path that robots are timed on.
#pragma once

#include "cdpr_kinetostatics/geometry/pose.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {

constexpr double kPathStep = 0.01;  // [m]

// A circle that rises and falls within a robot's workspace, traversed once or more often, after so much way [m].
Pose poseOnPath(const Workspace& workspace, double distance);

}  // namespace cdpr_kinetostatics

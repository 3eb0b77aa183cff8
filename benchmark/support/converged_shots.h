// Shots as they occur in a solve: three bending layers each, starting on converged cables.
#pragma once

#include <vector>

#include "cable/shot.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

struct ShotProblem {
  ShotParameters parameters;
  double t0 = 0.0;
  double t1 = 0.0;
  ShotState start;
};

// Of every cable of the robot at the pose, those within most_layers of an end: farther away a solve needs no shots.
std::vector<ShotProblem> convergedShots(const RobotDescription& robot, const Pose& pose, double most_layers);

}  // namespace cdpr_kinetostatics

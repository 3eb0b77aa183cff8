// Where the simulated platform is to be at a time.
#pragma once

#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "rig/parameters.h"

namespace cdpr_kinetostatics {

// The poses of a circle, a figure of eight or waypoints, at a time since the start [s]. Circles start at home. They
// are horizontal, except for a point mass on two cables, which moves in their vertical plane.
class FixedPath {
 public:
  FixedPath(const RobotDescription& robot, const RigPath& path, double radius);

  Pose at(double time) const;
  double duration() const;  // until it repeats [s]

 private:
  Pose onCurve(double phase) const;
  Pose alongWaypoints(double time) const;

  const RigPath path_;
  const double radius_;  // [m]
  Pose home_;
  Eigen::Vector3d first_, second_;  // unit vectors of the plane
};

// From one pose towards another at a speed [m/s], for a time step [s]. Turns arrive together with positions.
Pose stepTowards(const Pose& from, const Pose& target, double speed, double step);

}  // namespace cdpr_kinetostatics

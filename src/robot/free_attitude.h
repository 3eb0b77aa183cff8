// What inverse kinetostatics may turn of the platform's attitude: nothing, everything, or all but the heading.
#pragma once

#include <Eigen/Core>

#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// Changes of an attitude: a rotation vector, or with the heading held (pitch, roll) of R = Rz(yaw) Ry(pitch) Rx(roll).
class FreeAttitude {
 public:
  using Turn = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;
  using Axes = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

  FreeAttitude() = default;
  // The heading that is held is that of the request's pose.
  FreeAttitude(const RobotDescription& robot, const InverseRequest& request);

  int freedoms() const { return freedoms_; }
  bool holdsHeading() const { return freedoms_ == 2; }

  // The rotation vector, world axes, per unit of each change at this pose.
  Axes axes(const Pose& pose) const;
  Pose turned(const Pose& pose, const Turn& turn) const;
  // The pose with the attitude nearest to this one that may be asked for: with the heading put right.
  Pose allowed(const Pose& pose) const;

  // Limits of the next change: what a linearisation serves for, and a pitch below a right angle, beyond which the
  // heading would be another.
  Turn least(const Pose& pose) const;
  Turn most(const Pose& pose) const;

 private:
  int freedoms_ = 0;
  double yaw_ = 0.0;
};

}  // namespace cdpr_kinetostatics

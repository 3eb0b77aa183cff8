// The platform on straight springs that pull but do not push, and its descent to a stable pose (docs/theory.md section
// 5, "Forward kinetostatics").
//
// The energy of such a platform is bounded below, and every descent ends in a minimum: a stable equilibrium
// near the start. That makes it the way from a far seed to the right pose, for every model.
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot/search_outcome.h"

namespace cdpr_kinetostatics {

// Tension shift + stiffness (way - length); never negative unless two_sided. The way is that of a straight rope, around
// its guide pulley if there is one.
struct Spring {
  double stiffness = 0.0;  // [N/m]
  double length = 0.0;     // [m]
  double shift = 0.0;      // [N]
  bool two_sided = false;
  double held = 0.0;  // of its length, what hangs at a pulley and not at the platform [m]

  double tension(double way) const;
  double halfWeight(const CableProperties& cable) const { return 0.5 * cable.weight * (length - held); }
};

// As stiff as a cable of this length with the dead part behind it.
Spring springOf(const CableProperties& cable, double length);

// The straight rope from a cable's anchor to the platform, in the world.
struct SpringWay {
  double length = 0.0;   // from the anchor [m]
  double chord = 0.0;    // of its free part [m]
  Eigen::Vector3d unit;  // along the free part, towards the platform
  double across = 0.0;   // by how much more than 1/chord the direction turns with a motion across the plane [1/m]
  Eigen::Vector3d side = Eigen::Vector3d::Zero();  // across the plane
};
SpringWay springWay(const CableDescription& cable, const Pose& pose, double least_chord = 0.0);

class SpringPlatform {
 public:
  // external: the wrench besides the platform's weight and half of each cable's; null: no loads at all.
  // Robot and wrench must outlive the object.
  SpringPlatform(const RobotDescription& robot, const Wrench* external) : robot_(robot), external_(external) {}

  // The descent has settled where the pose moves by less than this share of the tolerance.
  static constexpr double kSettled = 0.01;

  struct Local {
    double energy = 0.0;  // [J], without the external torque, whose work depends on the path
    Wrench wrench = Wrench::Zero();
    // d(wrench)/d(translation, rotation vector)
    Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
  };
  Local at(const Pose& pose, const std::vector<Spring>& springs) const;

  // Descends first on springs that the platform's weight stretches by 1 %, then on stiffer ones up to those
  // given: far from equilibrium, stiff springs make narrow curved valleys. Ends when the pose moves by less
  // than tolerance, relative to the robot's span, and in rad.
  SearchOutcome descend(const std::vector<Spring>& springs, double tolerance,
                        std::chrono::steady_clock::time_point deadline, Pose* pose) const;

 private:
  struct Move;

  // Newton's method, damped until the energy falls.
  SearchOutcome newton(const std::vector<Spring>& springs, double tolerance,
                       std::chrono::steady_clock::time_point deadline, Pose* pose) const;
  // Newton's step from here under this damping, no longer than the platform may move at once. False: the damped
  // Hessian is not positive definite.
  bool step(const Local& here, double damping, Move* move) const;
  // The wrench vanishes on saddles of the energy, too, and on its tops: moves to a lower point beside one. False where
  // the pose is none of them.
  bool leaveSaddle(const std::vector<Spring>& springs, Local* here, Pose* pose) const;
  // By which the energy falls from here to there, the work of the external torque included [J].
  double gain(const Local& here, const Local& there, const Eigen::Vector3d& turn) const;
  // Below this a difference of energies is rounding [J].
  double rounding(const Local& here) const;
  Residuals residuals(const Local& here) const;

  const RobotDescription& robot_;
  const Wrench* external_;
};

}  // namespace cdpr_kinetostatics

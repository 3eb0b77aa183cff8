// Equilibrium and closure of a robot's solution, computed anew from (H, V, L), the pose and the robot's
// geometry alone, with formulas written out here: nothing of the robot layer is called.
#pragma once

#include <string>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

// The end B of cable in the world: turned by the quaternion's matrix, written out.
Eigen::Vector3d attachmentInWorld(const Pose& pose, const Eigen::Vector3d& attachment);

struct PlaneForces {
  double h = 0.0;       // [N]
  double v = 0.0;       // [N]
  double length = 0.0;  // unstrained [m]
};

// Force and moment about the origin of cables, weight and external wrench.
Wrench totalWrench(const RobotDescription& robot, const Wrench& external, const Pose& pose,
                   const std::vector<PlaneForces>& forces);

// The textbook elastic catenary's end.
Eigen::Vector2d textbookCatenaryEnd(const CableProperties& cable, const PlaneForces& forces);

struct RobotAudit {
  double force = 0.0;        // norm of the unbalanced force over the platform's weight
  double moment = 0.0;       // the same of the moment, over weight times span
  double closure = 0.0;      // largest distance of a cable's end from B [m]
  double below_limit = 0.0;  // largest T_A/tension_min below 1, and above tension_max: relative excess
  double above_limit = 0.0;
};

// closure: catenaries by the textbook formula, the other rungs by problem 1 of the single cable.
RobotAudit audit(const RobotDescription& robot, const Wrench& external, const RobotSolution& solution);

// For a solution with profiles: every profile point of every bending cable is integrated, by classical
// Runge-Kutta steps, to the next one; the largest distance from it, in m. B counts as the last point.
double largestProfileDefect(const RobotDescription& robot, const RobotSolution& solution, int steps);

// The largest eigenvalue of the stiffness at fixed lengths, by differences of wrenches whose cables are solved one by
// one for their forces: above zero, the platform leaves the pose. NaN where a cable was not solved.
double largestStiffness(const RobotDescription& robot, const RobotSolution& solution, Model model);

}  // namespace cdpr_kinetostatics

// Where the cables attach at a pose, what they pull with, and how the pose moves.
#pragma once

#include "cdpr_kinetostatics/robot/pose.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// A cable's end B at a pose, in the world and in the cable's vertical plane (docs/theory.md section 5).
struct CableLine {
  Eigen::Vector3d arm;        // R b, world axes [m]
  Eigen::Vector3d direction;  // e, horizontal unit vector from A to B; +x of the world if B is above or below A
  double x = 0.0;             // B in the plane [m], x >= 0
  double w = 0.0;
};

CableLine cableLine(const CableDescription& cable, const Pose& pose);

// Horizontal distance of B from A where H and its density H/x stand for each other [m]: never 0, B above or below A is
// taken a 1e-9th of the length beside it.
double distanceBeside(const CableLine& line, double length);

// Force of a cable on the platform: -H e + (V - q L) z [N].
Eigen::Vector3d forceOnPlatform(const CableLine& line, double horizontal_force, double vertical_force_a,
                                double cable_weight);

// H/x [N/m], by which a cable resists motion out of its plane; stiffness: d(H, V)/d(x, w). A vertical cable resists
// alike in all directions.
double forceDensity(const CableLine& line, double horizontal_force, const Eigen::Matrix2d& stiffness);

// A force that acts at arm from the platform origin.
Wrench wrenchAt(const Eigen::Vector3d& arm, const Eigen::Vector3d& force);

// The platform's weight and the external wrench.
Wrench loadWrench(const RobotDescription& robot, const Pose& pose, const Wrench& external);

// d(wrench of the weight)/d(translation, rotation vector).
Eigen::Matrix<double, 6, 6> weightStiffness(const RobotDescription& robot, const Pose& pose);

// The matrix of v -> a x v.
Eigen::Matrix3d cross(const Eigen::Vector3d& a);

// The pose moved by a translation and turned by a rotation vector, both in world axes.
Pose displaced(const Pose& pose, const Eigen::Vector3d& translation, const Eigen::Vector3d& rotation);

}  // namespace cdpr_kinetostatics

// What a cable robot is: anchors, platform, cables. Immutable once loaded; one serves many threads.
//
// Frames (docs/conventions.md): world W, z up; platform P. Anchor A_i in W, attachment b_i in P.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/geometry/pose.h"

namespace cdpr_kinetostatics {

enum class PlatformType { kRigidBody, kPointMass };

struct CableDescription {
  std::string name;
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();      // A_i [m], world; where the rope reaches its pulley or eyelet
  Eigen::Vector3d attachment = Eigen::Vector3d::Zero();  // b_i [m], platform frame
  CableProperties properties;
  double tension_min = 0.0;  // [N], of T_A
  double tension_max = 0.0;  // [N], of T_A

  // What the cable's drive reports, as a position: unstrained length [m] = scale * position + offset.
  double scale = 1.0;   // not 0 [m per unit of position]
  double offset = 0.0;  // [m]

  double lengthAt(double position) const { return scale * position + offset; }
  double positionAt(double length) const { return (length - offset) / scale; }
};

struct RobotDescription {
  std::string name;
  double gravity = 9.81;  // [m/s^2]
  PlatformType type = PlatformType::kRigidBody;
  double mass = 0.0;                               // [kg]
  Eigen::Vector3d com = Eigen::Vector3d::Zero();   // [m], platform frame
  Pose home;                                       // seed of the first solve
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  // [m], drawing only
  std::vector<CableDescription> cables;

  int freedoms() const { return type == PlatformType::kPointMass ? 3 : 6; }
  double weight() const { return mass * gravity; }  // [N]
  // Largest distance between two anchors; where all are one point, from there to home [m].
  double span() const;
  // Largest distance of an attachment from the platform origin [m]; 0 for a point mass.
  double platformRadius() const;
  // What turns moments into forces, and rotations into displacements, of comparable size [m]: the platform's radius,
  // but a point of attachment at the origin leaves a millionth of the span, so that moments never drop out of a
  // balance.
  double lever() const;
};

}  // namespace cdpr_kinetostatics

// The straight rope between where a cable begins and its end B: around the guide pulley if there is one, and on along
// the tangent. What searches start from and springs follow.
//
// Without a pulley it is the chord.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "cable/forces_at_a.h"
#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/cable/report.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "geometry/cable_plane.h"

namespace cdpr_kinetostatics {

struct StraightRope {
  Eigen::Vector2d free;  // in the cable's plane, from where it leaves the pulley to B [m]
  double wrapped = 0.0;  // on the pulley [m]

  double chord() const { return std::hypot(free.x(), free.y()); }  // of the free part [m]
  double length() const { return chord() + wrapped; }              // from A [m]
};

// Its free part alone, without the arc.
Eigen::Vector2d straightFreePart(const CableProperties& cable, double x, double y);

// To (x, y) in the cable's plane. A point within the pulley is taken as if there were none: searches pass through it,
// answers do not.
StraightRope straightRope(const CableProperties& cable, double x, double y);

// Whether every cable's rope can go to where the platform holds its end: INFEASIBLE, with the name of one that cannot.
Status checkPulleys(const RobotDescription& robot, const Pose& pose);

// Where a rope leaves its pulley, from A [m], and how much of a length L hangs freely and has weight [m], as far as
// forces alone tell: exact without bending stiffness, to first order with it.
Eigen::Vector2d departureUnder(const CableProperties& cable, const ForcesAtA& forces);
double freeLengthUnder(const CableProperties& cable, double length, const ForcesAtA& forces);

// d(H, vertical force at B)/d(H, V) of a linearised cable at constant length: a change of forces at A turns the rope
// around its pulley, and with it changes the weight that hangs. The identity without a pulley.
Eigen::Matrix2d forcesAtB(const SaggingCable& cable);

}  // namespace cdpr_kinetostatics

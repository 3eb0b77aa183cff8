// The vertical plane of a cable: where its end B lies in it at a pose, and how its forces act on the platform
// (docs/theory.md section 5).
#pragma once

#include <Eigen/Core>

#include "cdpr_kinetostatics/geometry/pose.h"

namespace cdpr_kinetostatics {

// The plane through the anchor A and the attachment B, A at the origin, x horizontal towards B, y up.
struct CablePlane {
  Eigen::Vector3d arm;        // R b, from the platform's origin to B, world axes [m]
  Eigen::Vector3d direction;  // e, horizontal unit vector from A to B; +x of the world if B is above or below A
  double x = 0.0;             // B in the plane [m], x >= 0
  double y = 0.0;

  // Takes a vector of the world into the plane: rows e and z.
  Eigen::Matrix<double, 2, 3> toPlane() const;
  // Takes forces (H, V) at A to the force on the platform: columns -e and z, equation (31).
  Eigen::Matrix<double, 3, 2> forceByForces() const;
  // Horizontal unit vector across the plane.
  Eigen::Vector3d side() const { return {-direction.y(), direction.x(), 0.0}; }
};

// From the anchor A (world) to the attachment b (platform frame) at a pose: B - A [m].
Eigen::Vector3d anchorToAttachment(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment, const Pose& pose);

CablePlane cablePlane(const Eigen::Vector3d& anchor, const Eigen::Vector3d& attachment, const Pose& pose);

// Horizontal distance of B from A where H and its density H/x stand for each other [m]: never 0, B above or below A is
// taken a small share of the length beside it.
double distanceBeside(double x, double length);

// Force of a cable on the platform: -H e + (V - q L) z [N], equation (31).
Eigen::Vector3d forceOnPlatform(const CablePlane& plane, double horizontal_force, double vertical_force_a,
                                double cable_weight);

// The same from the vertical force that lifts B, which a guide pulley's share of the cable's weight does not reduce
// [N].
Eigen::Vector3d forceAtB(const CablePlane& plane, double horizontal_force, double vertical_force_b);

// The wrench that changes of (H, V) at a fixed end bring to the platform.
Eigen::Matrix<double, 6, 2> wrenchByForces(const CablePlane& plane);

// H/x [N/m], by which a cable resists motion out of its plane; stiffness: d(H, V)/d(x, y). A vertical cable resists
// alike in all directions.
double forceDensity(const CablePlane& plane, double horizontal_force, const Eigen::Matrix2d& stiffness);

// Adds a cable's part of the robot's stiffness, equation (35): its force on the platform changes with its end by
// stiffness, d(H, V)/d(x, y), in its plane, and by -density out of it, as the plane turns with B.
void addCableStiffness(const CablePlane& plane, const Eigen::Matrix2d& stiffness, const Eigen::Vector3d& force,
                       double density, Eigen::Matrix<double, 6, 6>* total);

}  // namespace cdpr_kinetostatics

// What lies before the free part of a cable: the rope on its guide pulley and the dead part behind it, (40) to (42) of
// docs/theory.md.
//
// The cable's plane, A0 the origin; alpha is the slope with which the rope leaves the pulley [rad].
#pragma once

#include <Eigen/Core>
#include <optional>

#include "cable/forces_at_a.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/report.h"

namespace cdpr_kinetostatics {

inline bool hasPulley(const CableProperties& cable) { return cable.pulley.radius > 0.0; }

// All of the cable is free: A is an eyelet, and nothing that stretches lies behind it.
inline bool beginsAtEyelet(const CableProperties& cable) { return !hasPulley(cable) && cable.dead_length == 0.0; }

// The same cable as it hangs from the point where it leaves the pulley.
CableProperties freePartOf(const CableProperties& cable);

// 1 where the rope comes from below, -1 where it comes from above: the sense in which it goes around.
inline double senseOf(const GuidePulley& pulley) { return pulley.rope_from == RopeFrom::kBelow ? 1.0 : -1.0; }

// phi of (40) [rad]; it has to lie in (0, pi].
double wrapAngle(const GuidePulley& pulley, double alpha);

// P of (40) [m], and its derivative by alpha.
Eigen::Vector2d departurePoint(const GuidePulley& pulley, double alpha);
Eigen::Vector2d departureDerivative(const GuidePulley& pulley, double alpha);

// M(0) of the free part [N m]: the curvature of the rope goes on from the pulley's.
double momentAtDeparture(const CableProperties& cable);

// The slope at which a taut rope without weight leaves: along the force without bending stiffness, and turned from it
// by its bending layer with, (45) [rad].
double tautDeparture(const CableProperties& cable, const ForcesAtA& forces);

// L less the length of the free part, (41): what is wrapped around the pulley, less what the dead part gives [m]; and
// its derivatives by H, V and alpha.
struct HeldRope {
  double length = 0.0;
  Eigen::Vector2d by_forces = Eigen::Vector2d::Zero();
  double by_angle = 0.0;
};
HeldRope heldRope(const CableProperties& cable, const ForcesAtA& forces, double alpha);

// The straight line from the pulley to a point: the slope of the rope and its length from A0. Empty if the point is
// within the pulley.
struct TangentLine {
  double angle = 0.0;   // [rad]
  double length = 0.0;  // from A0, around the pulley and on [m]
};
std::optional<TangentLine> tangentLine(const GuidePulley& pulley, double x, double y);

// The length of the straight line from A to a point, around the pulley if there is one. The point must not lie within
// the pulley.
double straightWay(const CableProperties& cable, double x, double y);

// Where the rope cannot go to by that line: INFEASIBLE with a sentence; otherwise CONVERGED.
Status checkReach(const GuidePulley& pulley, double x, double y);

// Whether a rope that leaves like this goes around the pulley, by more than nothing and at most half a turn: INFEASIBLE
// with a sentence, or CONVERGED.
Status checkWrap(const GuidePulley& pulley, double alpha);

// The same, and whether the pulley holds the rope: it pulls, and the pulley does not have to hold it down. Without
// bending stiffness the rope has no shear where it leaves; there the curvature is what counts.
Status checkContact(const CableProperties& cable, const ForcesAtA& forces, double alpha);

// INFEASIBLE: the pulley cannot hold the rope.
Status liftsOff(const GuidePulley& pulley);
// Whether that is about to happen under these forces; and what is said where nothing was found then (NOT_CONVERGED).
bool isTooStiff(const CableProperties& cable, const ForcesAtA& forces);
Status mayLiftOff(const GuidePulley& pulley);

}  // namespace cdpr_kinetostatics

#include "robot/straight_rope.h"

#include <cmath>

#include "cable/rope_on_pulley.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {

// The way from the pulley's centre, turned by the angle whose sine is the radius over that way, and as long as the
// tangent.
Eigen::Vector2d straightFreePart(const CableProperties& cable, double x, double y) {
  const double r = cable.pulley.radius;
  const Eigen::Vector2d way(x - r, y);
  const double square = way.squaredNorm();
  if (r == 0.0 || !(square > r * r)) return {x, y};
  const double tangent = std::sqrt(square - r * r);
  const Eigen::Vector2d across = senseOf(cable.pulley) * r * Eigen::Vector2d(way.y(), -way.x());
  return tangent / square * (tangent * way + across);
}

StraightRope straightRope(const CableProperties& cable, double x, double y) {
  StraightRope rope{straightFreePart(cable, x, y)};
  if (!hasPulley(cable)) return rope;
  const std::optional<TangentLine> line = tangentLine(cable.pulley, x, y);
  if (line) rope.wrapped = cable.pulley.radius * wrapAngle(cable.pulley, line->angle);
  return rope;
}

Status checkPulleys(const RobotDescription& robot, const Pose& pose) {
  for (const CableDescription& cable : robot.cables) {
    if (!hasPulley(cable.properties)) continue;
    const CablePlane plane = cablePlane(cable, pose);
    Status reach = checkReach(cable.properties.pulley, plane.x, plane.y);
    if (reach.ok()) continue;
    reach.message = "cable '" + cable.name + "': " + reach.message;
    return reach;
  }
  return {Code::kConverged, ""};
}

Eigen::Vector2d departureUnder(const CableProperties& cable, const ForcesAtA& forces) {
  if (!hasPulley(cable)) return Eigen::Vector2d::Zero();
  return departurePoint(cable.pulley, tautDeparture(cable, forces));
}

double freeLengthUnder(const CableProperties& cable, double length, const ForcesAtA& forces) {
  if (beginsAtEyelet(cable)) return length;
  return length - heldRope(cable, forces, tautDeparture(cable, forces)).length;
}

Eigen::Matrix2d forcesAtB(const SaggingCable& cable) {
  Eigen::Matrix2d at_b;
  at_b << 1.0, 0.0, cable.verticalForceBDerivative().head<2>();
  return at_b;
}

}  // namespace cdpr_kinetostatics

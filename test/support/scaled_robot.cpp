#include "scaled_robot.h"

namespace cdpr_kinetostatics {
namespace {

Wrench scaledWrench(const Scale& scale, const Wrench& wrench) {
  Wrench other;
  other << scale.force * wrench.head<3>(), scale.moment() * wrench.tail<3>();
  return other;
}

}  // namespace

CableProperties scaled(const Scale& scale, const CableProperties& cable) {
  return {cable.axial_stiffness * scale.force, cable.bending_stiffness * scale.moment() * scale.length,
          cable.weight * scale.force / scale.length};
}

RobotDescription scaled(const Scale& scale, const RobotDescription& robot) {
  RobotDescription other = robot;
  other.mass *= scale.force;
  other.com *= scale.length;
  other.home = scaled(scale, robot.home);
  other.size *= scale.length;
  for (CableDescription& cable : other.cables) {
    cable.anchor *= scale.length;
    cable.attachment *= scale.length;
    cable.properties = scaled(scale, cable.properties);
    cable.tension_min *= scale.force;
    cable.tension_max *= scale.force;
  }
  return other;
}

Pose scaled(const Scale& scale, const Pose& pose) {
  Pose other = pose;
  other.position *= scale.length;
  return other;
}

InverseRequest scaled(const Scale& scale, const InverseRequest& request) {
  InverseRequest other = request;
  other.pose = scaled(scale, request.pose);
  other.external_wrench = scaledWrench(scale, request.external_wrench);
  for (double& tension : other.preferred_tensions) tension *= scale.force;
  return other;
}

ForwardRequest scaled(const Scale& scale, const ForwardRequest& request) {
  ForwardRequest other = request;
  for (double& length : other.lengths) length *= scale.length;
  other.external_wrench = scaledWrench(scale, request.external_wrench);
  if (request.seed) other.seed = scaled(scale, *request.seed);
  return other;
}

RobotSolverOptions scaled(const Scale& scale, const RobotSolverOptions& options) {
  RobotSolverOptions other = options;
  other.accuracy *= scale.length;
  return other;
}

}  // namespace cdpr_kinetostatics

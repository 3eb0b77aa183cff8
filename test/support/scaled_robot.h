// The same cable, robot or request in other units: lengths times a, forces times b. The mechanics knows no unit, so
// answers are the same, in the other units.
#pragma once

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"

namespace cdpr_kinetostatics {

struct Scale {
  double length = 1.0;
  double force = 1.0;

  double moment() const { return force * length; }
};

CableProperties scaled(const Scale& scale, const CableProperties& cable);
RobotDescription scaled(const Scale& scale, const RobotDescription& robot);
Pose scaled(const Scale& scale, const Pose& pose);
InverseRequest scaled(const Scale& scale, const InverseRequest& request);
ForwardRequest scaled(const Scale& scale, const ForwardRequest& request);
RobotSolverOptions scaled(const Scale& scale, const RobotSolverOptions& options);

}  // namespace cdpr_kinetostatics

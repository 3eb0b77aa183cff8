#include "robot/platform_error.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "cable/auto_policy.h"
#include "robot/linear_robot.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
PlatformError platformError(const RobotDescription& robot, const Pose& pose, const std::vector<CableSolution>& cables) {
  PlatformError error;
  LinearRobot linear(robot);
  linear.start(pose);
  Wrench unbalanced = Wrench::Zero();
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const CableProperties& properties = robot.cables[i].properties;
    const CablePlane plane = cablePlane(robot.cables[i], pose);
    const RungError of_cable = rungError(properties, cables[i]);
    const double h = cables[i].horizontal_force;
    linear.add(plane, of_cable.stiffness, h, forceAtB(plane, h, cables[i].vertical_force_b));
    unbalanced += wrenchByForces(plane) * of_cable.force;
    error.known = error.known && of_cable.known;
    error.cables.push_back(of_cable);
  }
  if (!linear.factorise()) {
    error.known = false;
    return error;
  }
  const Wrench displacement = linear.displacement(unbalanced);
  error.translation = displacement.head<3>().norm();
  error.rotation = displacement.tail<3>().norm() / linear.lever();
  return error;
}

bool isWithin(const RobotDescription& robot, const RobotSolution& solution, double accuracy) {
  const RobotReport& report = solution.report;
  const double error = std::max(report.estimated_error, report.estimated_rotation_error * robot.lever());
  const bool lines = std::any_of(solution.cables.begin(), solution.cables.end(),
                                 [](const CableResult& cable) { return isStraight(cable.cable.model); });
  return report.error_known && error <= (lines ? kEnoughOnLines : kEnough) * accuracy;
}

std::string describeChoice(const RobotSolution& solution) {
  std::ostringstream text;
  const char* separator = "";
  for (const Model model : kAutoRungs) {
    const auto count = std::count_if(solution.cables.begin(), solution.cables.end(),
                                     [&](const CableResult& cable) { return cable.cable.model == model; });
    if (count == 0) continue;
    text << separator << modelName(model) << " for " << count << (count == 1 ? " cable" : " cables");
    separator = ", ";
  }
  if (solution.report.model != Model::kBending || solution.report.estimated_error > 0.0) {
    text.precision(2);
    text << "; what this neglects moves the platform by " << solution.report.estimated_error << " m";
  }
  return text.str();
}

}  // namespace cdpr_kinetostatics

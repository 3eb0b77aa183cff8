#include "robot/solution_assembly.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "cable/tautness.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "robot/platform_error.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kLimitTolerance = 1e-9;    // a tension this near to its limit has reached it
constexpr double kLargestCoordinate = 1e6;  // [m]
constexpr double kLargestLoad = 1e12;       // [N], [N m]

Status invalid(const std::string& message) { return {Code::kInvalidInput, message}; }

}  // namespace

Condition conditionOf(const CableSolution& cable, double tension_min) {
  if (pushes({cable.horizontal_force, cable.vertical_force_a})) return Condition::kCompressed;
  const bool slack = cable.length > kSlackExcess * std::hypot(cable.x, cable.y) ||
                     cable.tension_a < tension_min * (1.0 - kLimitTolerance);
  return slack ? Condition::kSlack : Condition::kTaut;
}

RobotSolution refusedRobot(Model model, const Status& status) {
  RobotSolution solution;
  solution.report.status = status;
  solution.report.model = model;
  return solution;
}

Status checkRobotOptions(const RobotSolverOptions& options) {
  if (!(options.tolerance >= 1e-13 && options.tolerance <= 0.1)) {
    std::ostringstream text;
    text << "tolerance = " << options.tolerance << " must lie between 1e-13 and 0.1";
    return invalid(text.str());
  }
  if (!(options.accuracy > 0.0 && options.accuracy <= kLargestCoordinate)) {
    std::ostringstream text;
    text << "accuracy = " << options.accuracy << " m must be positive and at most 1e6 m";
    return invalid(text.str());
  }
  return checkModel(options.model);
}

Status checkWrench(const RobotDescription& robot, const Wrench& external) {
  if (!external.allFinite() || external.norm() > kLargestLoad) {
    return invalid("external_wrench must be finite and at most 1e12 N and N m");
  }
  if (robot.type == PlatformType::kPointMass && external.tail<3>().norm() > 0.0) {
    return invalid("a point mass takes no torque: external_wrench.torque must be zero");
  }
  return {Code::kConverged, ""};
}

Status checkPose(const Pose& pose) {
  if (!pose.position.allFinite() || pose.position.norm() > kLargestCoordinate) {
    return invalid("the pose's position must be finite and within 1e6 m");
  }
  if (!(std::abs(pose.orientation.norm() - 1.0) < 1e-6)) {
    return invalid("the pose's orientation must be a unit quaternion");
  }
  return {Code::kConverged, ""};
}

std::vector<CableSolution> describeCables(const RobotDescription& robot, const Pose& pose,
                                          const std::vector<SaggingCable>& cables, int profile_points) {
  std::vector<CableSolution> solutions;
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot.cables[i], pose);
    solutions.push_back(cables[i].describe(plane.x, plane.y, profile_points));
  }
  return solutions;
}

void assemble(const RobotDescription& robot, const Wrench& external, const std::vector<CableSolution>& cables,
              RobotSolution* solution) {
  RobotReport& report = solution->report;
  Wrench total = loadWrench(robot, solution->pose, external);
  report.closure_residual = 0.0;
  report.integrator_steps = report.evaluations = 0;
  solution->cables.resize(cables.size());
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const CableDescription& description = robot.cables[i];
    const CablePlane plane = cablePlane(description, solution->pose);
    CableResult& result = solution->cables[i];
    result.cable = cables[i];
    result.name = description.name;
    result.condition = conditionOf(cables[i], description.tension_min);
    result.direction = plane.direction;
    result.force_on_platform = forceOnPlatform(plane, cables[i].horizontal_force, cables[i].vertical_force_a,
                                               description.properties.weight * cables[i].length);
    total += wrenchAt(plane.arm, result.force_on_platform);
    report.closure_residual = std::max(report.closure_residual, cables[i].closure_residual);
    report.integrator_steps += cables[i].integrator_steps;
    report.evaluations += cables[i].evaluations;
    report.model = std::max(report.model, cables[i].model);
    result.profile.clear();
    for (const ProfilePoint& point : cables[i].profile) {
      result.profile.push_back(description.anchor + point.x * plane.direction + point.y * Eigen::Vector3d::UnitZ());
    }
  }
  const PlatformError error = platformError(robot, solution->pose, cables);
  report.estimated_error = error.translation;
  report.estimated_rotation_error = error.rotation;
  report.error_known = error.known;
  for (std::size_t i = 0; i < cables.size(); ++i) solution->cables[i].cable.estimated_error = error.cables[i];
  report.force_residual = total.head<3>().norm();
  report.moment_residual = robot.type == PlatformType::kPointMass ? 0.0 : total.tail<3>().norm();
}

}  // namespace cdpr_kinetostatics

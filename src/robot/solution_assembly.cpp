#include "robot/solution_assembly.h"

#include <algorithm>
#include <cmath>

#include "cable/tautness.h"
#include "robot/platform_error.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kLimitTolerance = 1e-9;  // a tension this near to its limit has reached it, relative [-]

}  // namespace

Condition conditionOf(const CableSolution& cable, double tension_min) {
  if (pushes({cable.horizontal_force, cable.vertical_force_a})) return Condition::kCompressed;
  const bool slack =
      cable.free_length > kSlackExcess * std::hypot(cable.x - cable.departure_x, cable.y - cable.departure_y) ||
      cable.tension_a < tension_min * (1.0 - kLimitTolerance);
  return slack ? Condition::kSlack : Condition::kTaut;
}

RobotSolution refusedRobot(Model model, const Status& status) {
  RobotSolution solution;
  solution.report.status = status;
  solution.report.model = model;
  return solution;
}

RobotSolution failedRobot(Model model, const SearchOutcome& outcome) {
  RobotSolution solution = refusedRobot(model, outcome.status);
  solution.report.iterations = outcome.iterations;
  solution.report.closure_residual = outcome.residuals.closure;
  solution.report.force_residual = outcome.residuals.force;
  solution.report.moment_residual = outcome.residuals.moment;
  return solution;
}

SearchOutcome outcomeOf(const RobotReport& report) {
  return {report.status, report.iterations, {report.closure_residual, report.force_residual, report.moment_residual}};
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
    result.force_on_platform = forceAtB(plane, cables[i].horizontal_force, cables[i].vertical_force_b);
    total += wrenchAt(plane.arm, result.force_on_platform);
    report.closure_residual = std::max(report.closure_residual, cables[i].closure_residual);
    report.integrator_steps += cables[i].integrator_steps;
    report.evaluations += cables[i].evaluations;
    report.model = std::max(report.model, cables[i].model);
    const auto inWorld = [&](double x, double y) -> Eigen::Vector3d {
      return description.anchor + x * plane.direction + y * Eigen::Vector3d::UnitZ();
    };
    result.departure = inWorld(cables[i].departure_x, cables[i].departure_y);
    result.profile.clear();
    for (const ProfilePoint& point : cables[i].profile) result.profile.push_back(inWorld(point.x, point.y));
  }
  const PlatformError error = platformError(robot, solution->pose, cables);
  report.estimated_error = error.translation;
  report.estimated_rotation_error = error.rotation;
  report.error_known = error.known;
  for (std::size_t i = 0; i < cables.size(); ++i) {
    solution->cables[i].cable.estimated_error = error.cables[i].displacement;
    solution->cables[i].cable.error_known = error.cables[i].known;
  }
  report.force_residual = total.head<3>().norm();
  report.moment_residual = robot.type == PlatformType::kPointMass ? 0.0 : total.tail<3>().norm();
}

}  // namespace cdpr_kinetostatics

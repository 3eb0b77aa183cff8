#include "tradeoff/scenario.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>

#include "cdpr_kinetostatics/robot/forward.h"

namespace cdpr_kinetostatics {
namespace {

// Distances of the poses from home, tried in this order [spans].
constexpr double kSharesOfSpan[] = {0.05, 0.02, 0.01};

// Distance of the pose before [m].
constexpr double kBefore = 0.01;

// A pose whose lengths lead back to it within this is a reference; otherwise there is another equilibrium nearby [m per
// metre of span].
constexpr double kSamePose = 1e-8;

InverseRequest requestAt(const RobotDescription& robot, const Eigen::Vector3d& position) {
  InverseRequest request;
  request.pose = {position, robot.home.orientation};
  request.free_orientation =
      robot.type == PlatformType::kRigidBody && static_cast<int>(robot.cables.size()) < robot.freedoms();
  return request;
}

std::optional<Scenario> scenarioAt(const RobotDescription& robot, const Eigen::Vector3d& position, Status* reason) {
  const Eigen::Vector3d way = position - robot.home.position;
  const Eigen::Vector3d direction = way.norm() > 0.0 ? Eigen::Vector3d(way.normalized()) : Eigen::Vector3d::UnitX();
  Scenario scenario;
  scenario.request = requestAt(robot, position);
  scenario.reference = solveInverse(robot, scenario.request, referenceOptions());
  if (scenario.reference.report.status.ok()) {
    scenario.previous = solveInverse(robot, requestAt(robot, position - kBefore * direction), referenceOptions());
  }
  for (const RobotSolution* solution : {&scenario.reference, &scenario.previous}) {
    *reason = solution->report.status;
    if (!reason->ok()) return std::nullopt;
  }
  ForwardRequest forward;
  forward.lengths = lengthsOf(scenario.reference);
  forward.seed = scenario.reference.pose;
  const RobotSolution back = solveForward(robot, forward, referenceOptions());
  *reason = back.report.status;
  if (!reason->ok()) return std::nullopt;
  if ((back.pose.position - scenario.reference.pose.position).norm() > kSamePose * robot.span()) {
    *reason = {Code::kWrongBranch, "its lengths lead to another pose"};
    return std::nullopt;
  }
  return scenario;
}

}  // namespace

RobotSolverOptions referenceOptions() {
  RobotSolverOptions options;
  options.model = Model::kBending;
  options.tolerance = kReferenceTolerance;
  options.timeout = std::chrono::duration<double>(10.0);
  return options;
}

std::vector<Scenario> scenariosFor(const RobotDescription& robot, int count) {
  std::vector<Eigen::Vector3d> positions;
  for (const double share : kSharesOfSpan) {
    for (const double sign : {1.0, -1.0}) {
      for (int axis = 0; axis < 3; ++axis) {
        positions.emplace_back(robot.home.position + sign * share * robot.span() * Eigen::Vector3d::Unit(axis));
      }
    }
  }
  positions.push_back(robot.home.position);
  std::vector<Scenario> scenarios;
  Status reason;
  for (const Eigen::Vector3d& position : positions) {
    if (static_cast<int>(scenarios.size()) == count) break;
    if (const std::optional<Scenario> scenario = scenarioAt(robot, position, &reason)) scenarios.push_back(*scenario);
  }
  if (scenarios.empty()) {
    throw std::runtime_error(
        "robot '" + robot.name +
        "': no pose at or around its home can be held, so there is nothing to measure; at home: " + reason.message);
  }
  return scenarios;
}

}  // namespace cdpr_kinetostatics

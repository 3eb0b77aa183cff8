#include "robot/basin_search.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cable/sagging_cable.h"
#include "cable/tautness.h"
#include "robot/platform_statics.h"
#include "robot/residual_blocks.h"
#include "robot/spring_platform.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxIterations = 200;

// Half the sum of squares of the residuals, all dimensionless, at which Newton's method takes over.
constexpr double kGoodEnough = 1e-22;
// Above this the search has ended in a valley that is no solution.
constexpr double kNoSolution = 1e-6;

// The springs' pose is a start for the catenaries': this much of the span is near enough.
constexpr double kSpringTolerance = 1e-4;

// The robot's span and the load: Ceres scales columns and bounds its damping by absolute numbers, so the search runs
// where both are 1.
struct Units {
  double length;  // [m]
  double force;   // [N]
};

RobotDescription inUnits(const Units& units, RobotDescription robot) {
  robot.mass /= units.force;
  robot.com /= units.length;
  for (CableDescription& cable : robot.cables) {
    cable.anchor /= units.length;
    cable.attachment /= units.length;
    CableProperties& properties = cable.properties;
    properties.axial_stiffness /= units.force;
    properties.bending_stiffness /= units.force * units.length * units.length;
    properties.weight *= units.length / units.force;
  }
  return robot;
}

Wrench inUnits(const Units& units, Wrench wrench) {
  wrench.head<3>() /= units.force;
  wrench.tail<3>() /= units.force * units.length;
  return wrench;
}

class StopWhenGoodEnough : public ceres::IterationCallback {
 public:
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    return summary.cost < kGoodEnough ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }
};

// The stable pose with straight elastic cables nearest to the start.
SearchOutcome descendWithSprings(const RobotDescription& robot, const Wrench& external,
                                 const std::vector<double>& lengths, std::chrono::steady_clock::time_point deadline,
                                 Pose* pose) {
  std::vector<Spring> springs;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    springs.push_back({robot.cables[i].properties.axial_stiffness / lengths[i], lengths[i]});
  }
  return SpringPlatform(robot, &external).descend(springs, kSpringTolerance, deadline, pose);
}

ForcesAtA roughForces(const RobotDescription& robot, std::size_t i, const Pose& pose, double length) {
  const CableDescription& cable = robot.cables[i];
  const CablePlane plane = cablePlane(cable, pose);
  const double chord = std::hypot(plane.x, plane.y);
  const double cable_weight = cable.properties.weight * length;
  if (length > kSurelyLonger * chord && cable_weight > 0.0) {
    const CableProperties seen = asSeenBy(Model::kCatenary, cable.properties);
    const auto catenary = catenaryForces(seen, length, std::max(plane.x, 1e-3 * length), plane.y);
    if (catenary && catenary->horizontal > 0.0) return *catenary;
  }
  const double share = std::max(robot.weight() / robot.freedoms(), 10.0 * cable_weight);
  const double x = distanceBeside(plane.x, length);
  return {share * x / chord, 0.5 * cable_weight - share * plane.y / chord};
}

}  // namespace

SearchOutcome roughStart(const RobotDescription& robot, const Wrench& external, const std::vector<double>& lengths,
                         std::chrono::steady_clock::time_point deadline, RobotForces* start) {
  SearchOutcome outcome = descendWithSprings(robot, external, lengths, deadline, &start->pose);
  start->lengths = lengths;
  start->forces.clear();
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    start->forces.push_back(roughForces(robot, i, start->pose, lengths[i]));
  }
  return outcome;
}

SearchOutcome searchBasin(const RobotDescription& robot, const Wrench& external, Model model, double tolerance,
                          std::chrono::steady_clock::time_point deadline, RobotForces* state) {
  SearchOutcome outcome;
  const std::size_t count = robot.cables.size();
  const Units units{robot.span(), std::max(robot.weight(), external.head<3>().norm())};
  const RobotDescription scaled = inUnits(units, robot);
  Eigen::Vector3d position = state->pose.position / units.length;
  Eigen::Quaterniond orientation = state->pose.orientation;
  std::vector<std::array<double, 2>> forces(count);
  std::vector<double> lengths(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = distanceBeside(cablePlane(robot.cables[i], state->pose).x, state->lengths[i]);
    lengths[i] = state->lengths[i] / units.length;
    forces[i] = {state->forces[i].horizontal / x * units.length / units.force, state->forces[i].vertical / units.force};
  }

  ceres::Problem problem;
  std::vector<double*> blocks = {position.data(), orientation.coeffs().data()};
  for (auto& force : forces) blocks.push_back(force.data());
  for (double& length : lengths) blocks.push_back(&length);
  const Wrench load = inUnits(units, external);
  Wrench weight;  // moments count as forces at the platform's radius
  weight << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / std::max(scaled.platformRadius(), 1e-3));
  problem.AddResidualBlock(equilibriumBlock(scaled, load, weight).release(), nullptr, blocks);
  for (std::size_t i = 0; i < count; ++i) {
    ceres::CostFunction* closure = closureBlock(scaled.cables[i], model, lengths[i], {tolerance, deadline}).release();
    problem.AddResidualBlock(closure, nullptr, position.data(), orientation.coeffs().data(), forces[i].data(),
                             &lengths[i]);
    problem.SetParameterBlockConstant(&lengths[i]);
  }
  if (robot.type == PlatformType::kRigidBody) {
    problem.SetManifold(orientation.coeffs().data(), new ceres::EigenQuaternionManifold);
  } else {
    problem.SetParameterBlockConstant(orientation.coeffs().data());
  }

  StopWhenGoodEnough stop;
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.max_num_iterations = kMaxIterations;
  options.function_tolerance = 0.0;
  options.gradient_tolerance = 0.0;
  options.parameter_tolerance = 1e-14;
  options.max_num_consecutive_invalid_steps = 50;
  options.max_solver_time_in_seconds =
      std::min(1e6, std::chrono::duration<double>(deadline - std::chrono::steady_clock::now()).count());
  options.callbacks.push_back(&stop);
  if (options.max_solver_time_in_seconds <= 0.0) {
    outcome.status = {Code::kTimedOut, "no time was left to look for the pose"};
    return outcome;
  }
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  outcome.iterations = static_cast<int>(summary.iterations.size());

  state->pose.position = units.length * position;
  state->pose.orientation = orientation.normalized();
  for (std::size_t i = 0; i < count; ++i) {
    const double x = distanceBeside(cablePlane(robot.cables[i], state->pose).x, state->lengths[i]);
    state->forces[i] = {units.force / units.length * forces[i][0] * x, units.force * forces[i][1]};
  }
  outcome.residuals = residualsOf(robot, external, model, *state);
  if (std::chrono::steady_clock::now() > deadline) {
    outcome.status = {Code::kTimedOut, "the time allowed ran out while looking for the platform's pose"};
  } else if (!summary.IsSolutionUsable() || summary.final_cost > kNoSolution) {
    outcome.status = {Code::kNotConverged, "no pose was found at which cables of these lengths balance the load"};
  } else {
    outcome.status.code = Code::kConverged;
  }
  return outcome;
}

}  // namespace cdpr_kinetostatics

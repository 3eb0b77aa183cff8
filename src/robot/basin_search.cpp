#include "robot/basin_search.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cable/pulley_cable.h"
#include "cable/sagging_cable.h"
#include "cable/tautness.h"
#include "robot/platform_statics.h"
#include "robot/residual_blocks.h"
#include "robot/spring_platform.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxIterations = 200;

// Half the sum of squares of the residuals, all dimensionless, at which Newton's method takes over.
constexpr double kGoodEnough = 1e-22;
// Above this the search has ended in a valley that is no solution.
constexpr double kNoSolution = 1e-6;

// The springs' pose is a start for the catenaries': this much of the span is near enough.
constexpr double kSpringTolerance = 1e-4;

// Least radius of a platform by which its moments are divided, as a share of the robot's span.
constexpr double kLeastRadius = 1e-3;

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
    properties.pulley.radius /= units.length;
    properties.dead_length /= units.length;
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

// The blocks of parameters, in these units. Ceres holds their addresses.
struct Unknowns {
  Eigen::Vector3d position;
  Eigen::Quaterniond orientation;
  std::vector<std::array<double, 2>> forces;  // (H/x, V) of each cable
  std::vector<double> lengths;                // constant
};

Unknowns inUnits(const Units& units, const RobotDescription& robot, const RobotForces& state) {
  Unknowns unknowns;
  unknowns.position = state.pose.position / units.length;
  unknowns.orientation = state.pose.orientation;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const ForcesAtA& forces = state.forces[i];
    const double x = distanceBeside(cablePlane(robot.cables[i], state.pose).x, state.lengths[i]);
    unknowns.lengths.push_back(state.lengths[i] / units.length);
    unknowns.forces.push_back({forces.horizontal / x * units.length / units.force, forces.vertical / units.force});
  }
  return unknowns;
}

// Back from these units, at the lengths that the state has.
void readInto(RobotForces* state, const Units& units, const RobotDescription& robot, const Unknowns& unknowns) {
  state->pose.position = units.length * unknowns.position;
  state->pose.orientation = unknowns.orientation.normalized();
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const auto& [density, vertical] = unknowns.forces[i];
    const double x = distanceBeside(cablePlane(robot.cables[i], state->pose).x, state->lengths[i]);
    state->forces[i] = {units.force / units.length * density * x, units.force * vertical};
  }
}

// Closure of every cable and the platform's equilibrium, equations (30) and (32). scaled and load: in the unknowns'
// units.
void addBlocks(const RobotDescription& scaled, const Wrench& load, Model model, const SolveLimits& limits,
               Unknowns* unknowns, ceres::Problem* problem) {
  double* position = unknowns->position.data();
  double* orientation = unknowns->orientation.coeffs().data();
  std::vector<double*> blocks = {position, orientation};
  for (auto& force : unknowns->forces) blocks.push_back(force.data());
  for (double& length : unknowns->lengths) blocks.push_back(&length);
  Wrench weight;  // moments count as forces at the platform's radius
  weight << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / std::max(scaled.platformRadius(), kLeastRadius));
  problem->AddResidualBlock(equilibriumBlock(scaled, load, weight).release(), nullptr, blocks);
  for (std::size_t i = 0; i < scaled.cables.size(); ++i) {
    double* length = &unknowns->lengths[i];
    ceres::CostFunction* closure = closureBlock(scaled.cables[i], model, *length, limits).release();
    problem->AddResidualBlock(closure, nullptr, position, orientation, unknowns->forces[i].data(), length);
    problem->SetParameterBlockConstant(length);
  }
  if (scaled.type == PlatformType::kRigidBody) {
    problem->SetManifold(orientation, new ceres::EigenQuaternionManifold);
  } else {
    problem->SetParameterBlockConstant(orientation);
  }
}

ceres::Solver::Options searchOptions(std::chrono::steady_clock::time_point deadline) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.max_num_iterations = kMaxIterations;
  options.function_tolerance = 0.0;
  options.gradient_tolerance = 0.0;
  options.parameter_tolerance = 1e-14;  // some digits above the rounding of numbers of size one
  options.max_num_consecutive_invalid_steps = 50;
  options.max_solver_time_in_seconds =
      std::min(1e6, std::chrono::duration<double>(deadline - std::chrono::steady_clock::now()).count());
  return options;
}

// The stable pose with straight elastic cables nearest to the start.
SearchOutcome descendWithSprings(const RobotDescription& robot, const Wrench& external,
                                 const std::vector<double>& lengths, std::chrono::steady_clock::time_point deadline,
                                 Pose* pose) {
  std::vector<Spring> springs;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    springs.push_back(springOf(robot.cables[i].properties, lengths[i]));
  }
  return SpringPlatform(robot, &external).descend(springs, kSpringTolerance, deadline, pose);
}

ForcesAtA roughForces(const RobotDescription& robot, std::size_t i, const Pose& pose, double length) {
  const CableDescription& cable = robot.cables[i];
  const CablePlane plane = cablePlane(cable, pose);
  const StraightRope rope = straightRope(cable.properties, plane.x, plane.y);
  const double chord = rope.chord();
  const double cable_weight = cable.properties.weight * (length - rope.wrapped);
  if (length > kSurelyLonger * rope.length() && cable_weight > 0.0) {
    const CableProperties seen = asSeenBy(Model::kCatenary, cable.properties);
    const auto catenary = hangingForces(seen, length, std::max(plane.x, 1e-3 * length), plane.y);
    if (catenary && catenary->horizontal > 0.0) return *catenary;
  }
  const double share = std::max(robot.weight() / robot.freedoms(), 10.0 * cable_weight);
  const double x = distanceBeside(rope.free.x(), length);
  return {share * x / chord, 0.5 * cable_weight - share * rope.free.y() / chord};
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
  const Units units{robot.span(), std::max(robot.weight(), external.head<3>().norm())};
  Unknowns unknowns = inUnits(units, robot, *state);
  ceres::Problem problem;
  addBlocks(inUnits(units, robot), inUnits(units, external), model, {tolerance, deadline}, &unknowns, &problem);
  StopWhenGoodEnough stop;
  ceres::Solver::Options options = searchOptions(deadline);
  options.callbacks.push_back(&stop);
  if (options.max_solver_time_in_seconds <= 0.0) {
    outcome.status = {Code::kTimedOut, "no time was left to look for the pose"};
    return outcome;
  }
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  readInto(state, units, robot, unknowns);
  outcome.iterations = static_cast<int>(summary.iterations.size());
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

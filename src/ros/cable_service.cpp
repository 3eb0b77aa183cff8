#include "ros/cable_service.h"

#include <chrono>
#include <cmath>
#include <limits>

#include "cable/cable_checks.h"
#include "cable/text.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "ros/conversions.h"
#include "ros/request_checks.h"
#include "ros/service_reply.h"

namespace cdpr_kinetostatics {

namespace {

using Clock = std::chrono::steady_clock;

// Of cables in messages: beyond these a number is a mistake of units.
constexpr double kLargestStiffness = 1e12;  // [N], [N m^2]
constexpr double kLargestDensity = 1e6;     // [kg/m]

struct Cable {
  std::string name;
  CableProperties properties;
  double tension_min = 0.0;  // [N]
};

RopeFrom requestedSide(const std::string& rope_from) {
  if (rope_from.empty() || rope_from == "below") return RopeFrom::kBelow;
  if (rope_from == "above") return RopeFrom::kAbove;
  throw RequestError(text("rope_from is '", rope_from, "': expected below or nothing, or above"));
}

Cable requestedCable(const SolveCable::Request& request, Model model, const RobotDescription& robot) {
  Cable cable;
  if (!request.cable_name.empty()) {
    const CableDescription& found = findCable(request.cable_name, robot);
    cable.name = found.name;
    cable.properties = found.properties;
    cable.tension_min = found.tension_min;
    return cable;
  }
  require(checkNotNegative("axial_stiffness", request.axial_stiffness, kLargestStiffness, "N"));
  require(checkNotNegative("bending_stiffness", request.bending_stiffness, kLargestStiffness, "N m^2"));
  require(checkNotNegative("linear_density", request.linear_density, kLargestDensity, "kg/m"));
  require(checkAxialStiffness(request.axial_stiffness, model), "; or give cable_name");
  cable.properties.axial_stiffness = request.axial_stiffness;
  cable.properties.bending_stiffness = request.bending_stiffness;
  cable.properties.weight = request.linear_density * robot.gravity;
  if (request.axial_stiffness == 0.0) {
    cable.properties.axial_stiffness = std::numeric_limits<double>::infinity();
  }
  cable.properties.pulley.radius = request.pulley_radius;
  cable.properties.pulley.rope_from = requestedSide(request.rope_from);
  cable.properties.dead_length = request.dead_length;
  require(checkZeroOrBetween("pulley_radius", request.pulley_radius, kLeastPulleyRadius, kLargestPulleyRadius, "m"));
  require(checkNotNegative("dead_length", request.dead_length, kLargestDeadLength, "m"));
  return cable;
}

CableSolution solveProblem(const SolveCable::Request& request, const CableProperties& cable,
                           const CableSolverOptions& options) {
  switch (request.problem) {
    case SolveCable::Request::FIND_POSITION:
      return findPosition(cable, request.length, request.horizontal_force, request.vertical_force_a, options);
    case SolveCable::Request::FIND_FORCES:
      return findForces(cable, request.length, request.x, request.y, options);
    case SolveCable::Request::FIND_LENGTH:
      require(checkWithin("length", request.length, kLargestLength, "m"));  // a hint to the core, of another name
      return findLength(cable, request.x, request.y, request.tension_a, request.length, options);
    default:
      throw RequestError(text("problem is ", int{request.problem},
                              ": expected FIND_POSITION = 1, FIND_FORCES = 2 or FIND_LENGTH = 3"));
  }
}

SolveCable::Response solve(const NodeParameters& parameters, const SolveCable::Request& request) {
  const auto start = Clock::now();
  const RobotSolverOptions checked = checkedOptions(request.options, request.profile_points, parameters);
  CableSolverOptions options;
  options.model = checked.model;
  options.accuracy = checked.accuracy;
  options.tolerance = checked.tolerance;
  options.profile_points = checked.profile_points;
  options.timeout = checked.timeout;
  const Cable cable = requestedCable(request, options.model, parameters.robot);

  const CableSolution solution = solveProblem(request, cable.properties, options);

  SolveCable::Response response;
  response.report = toMsg(solution.status);
  response.report.model = static_cast<std::uint8_t>(solution.model);
  response.report.iterations = solution.iterations;
  response.report.solve_time = std::chrono::duration<double>(Clock::now() - start).count();
  response.report.estimated_error = solution.estimated_error;
  response.report.closure_residual = solution.closure_residual;
  response.report.moment_residual = solution.moment_residual;
  response.cable = toMsg(solution, cable.name, conditionOf(solution, cable.tension_min));
  response.x = solution.x;
  response.y = solution.y;
  requireFinite(response.report, response.cable, response.x, response.y);
  return response;
}

}  // namespace

SolveCable::Response serveCable(const NodeParameters& parameters, const SolveCable::Request& request) {
  SolveCable::Response response;
  reply(response, [&] { return solve(parameters, request); });
  return response;
}

}  // namespace cdpr_kinetostatics

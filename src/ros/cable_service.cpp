#include "ros/cable_service.h"

#include <chrono>
#include <cmath>
#include <limits>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "ros/conversions.h"
#include "ros/request_checks.h"
#include "ros/service_reply.h"
#include "ros/text.h"

namespace cdpr_kinetostatics {

namespace {

using Clock = std::chrono::steady_clock;

struct Cable {
  std::string name;
  CableProperties properties;
  double tension_min = 0.0;  // [N]
};

Cable requestedCable(const SolveCable::Request& request, Model model, const RobotDescription& robot) {
  Cable cable;
  if (!request.cable_name.empty()) {
    const CableDescription& found = findCable(request.cable_name, robot);
    cable.name = found.name;
    cable.properties = found.properties;
    cable.tension_min = found.tension_min;
    return cable;
  }
  checkNotNegative("axial_stiffness", request.axial_stiffness, kMaxForce, "N");
  checkNotNegative("bending_stiffness", request.bending_stiffness, kMaxForce, "N m^2");
  checkNotNegative("linear_density", request.linear_density, kMaxDensity, "kg/m");
  cable.properties.axial_stiffness = request.axial_stiffness;
  cable.properties.bending_stiffness = request.bending_stiffness;
  cable.properties.weight = request.linear_density * robot.gravity;
  if (request.axial_stiffness > 0.0) return cable;
  if (!isInextensible(model)) {
    throw RequestError(text("axial_stiffness is 0 N: the model ", modelName(model),
                            " needs a positive one; give it, or cable_name, or ask for an inextensible model"));
  }
  cable.properties.axial_stiffness = std::numeric_limits<double>::infinity();
  return cable;
}

CableSolution solveProblem(const SolveCable::Request& request, const CableProperties& cable,
                           const CableSolverOptions& options) {
  switch (request.problem) {
    case SolveCable::Request::FIND_POSITION:
      checkPositive("length", request.length, kMaxLength, "m");
      checkWithin("horizontal_force", request.horizontal_force, kMaxForce, "N");
      checkWithin("vertical_force_a", request.vertical_force_a, kMaxForce, "N");
      return findPosition(cable, request.length, request.horizontal_force, request.vertical_force_a, options);
    case SolveCable::Request::FIND_FORCES:
      checkPositive("length", request.length, kMaxLength, "m");
      checkNotNegative("x", request.x, kMaxLength, "m");
      checkWithin("y", request.y, kMaxLength, "m");
      return findForces(cable, request.length, request.x, request.y, options);
    case SolveCable::Request::FIND_LENGTH:
      checkNotNegative("x", request.x, kMaxLength, "m");
      checkWithin("y", request.y, kMaxLength, "m");
      checkPositive("tension_a", request.tension_a, kMaxForce, "N");
      checkWithin("length", request.length, kMaxLength, "m");
      if (request.x == 0.0 && request.y == 0.0) {
        throw RequestError("x and y are both 0: expected an end B away from A, whose distance the length spans");
      }
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
  response.cable = toMsg(solution, cable.name, cable.properties.weight, conditionOf(solution, cable.tension_min));
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

#include "ros/forward_service.h"

#include "ros/conversions.h"
#include "ros/request_checks.h"
#include "ros/service_reply.h"

namespace cdpr_kinetostatics {

namespace {

ForwardKinetostatics::Response solve(const NodeParameters& parameters, const ForwardKinetostatics::Request& request) {
  const RobotDescription& robot = parameters.robot;
  RobotSolverOptions options = checkedOptions(request.options, request.profile_points, parameters);
  options.compute_stiffness = request.compute_stiffness != 0;

  ForwardRequest question;
  question.lengths = orderedLengths(request.lengths, request.cable_names, robot);
  question.external_wrench = fromMsg(request.external_wrench);
  if (request.use_seed) question.seed = checkedPose("seed", request.seed);

  const RobotSolution solution = solveForward(robot, question, options);

  ForwardKinetostatics::Response response;
  response.report = toMsg(solution.report);
  response.pose = toMsg(solution.cables.empty() ? robot.home : solution.pose);
  response.cables = toMsg(solution.cables);
  if (options.compute_stiffness && solution.report.status.ok()) response.stiffness = toMsg(solution.stiffness);
  requireFinite(response.report, response.pose, response.cables, response.stiffness);
  return response;
}

}  // namespace

ForwardKinetostatics::Response serveForward(const NodeParameters& parameters,
                                            const ForwardKinetostatics::Request& request) {
  ForwardKinetostatics::Response response;
  response.pose = toMsg(parameters.robot.home);
  reply(response, [&] { return solve(parameters, request); });
  return response;
}

}  // namespace cdpr_kinetostatics

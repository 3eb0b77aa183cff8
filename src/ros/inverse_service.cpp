#include "ros/inverse_service.h"

#include "ros/conversions.h"
#include "ros/request_checks.h"
#include "ros/service_reply.h"

namespace cdpr_kinetostatics {

namespace {

InverseKinetostatics::Response solve(const NodeParameters& parameters, const InverseKinetostatics::Request& request) {
  const RobotDescription& robot = parameters.robot;
  const RobotSolverOptions options = checkedOptions(request.options, request.profile_points, parameters);

  InverseRequest question;
  question.pose = checkedPose("pose", request.pose);
  question.free_orientation = request.free_orientation != 0;
  question.hold_yaw = request.hold_yaw != 0;
  question.external_wrench = fromMsg(request.external_wrench);
  question.preferred_tensions = request.preferred_tensions;

  const RobotSolution solution = solveInverse(robot, question, options);

  InverseKinetostatics::Response response;
  response.report = toMsg(solution.report);
  response.pose = toMsg(solution.cables.empty() ? robot.home : solution.pose);
  response.cables = toMsg(solution.cables);
  for (const CableState& cable : response.cables) response.lengths.push_back(cable.length);
  requireFinite(response.report, response.pose, response.cables);
  return response;
}

}  // namespace

InverseKinetostatics::Response serveInverse(const NodeParameters& parameters,
                                            const InverseKinetostatics::Request& request) {
  InverseKinetostatics::Response response;
  response.pose = toMsg(parameters.robot.home);
  reply(response, [&] { return solve(parameters, request); });
  return response;
}

}  // namespace cdpr_kinetostatics

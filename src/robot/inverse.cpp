#include "cdpr_kinetostatics/robot/inverse.h"

#include "robot/inverse_solve.h"
#include "robot/platform_error.h"
#include "robot/robot_checks.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {

Status checkInverse(const RobotDescription& robot, const InverseRequest& request, const RobotSolverOptions& options) {
  return firstRefusal(checkRobotOptions(options), checkPose("pose", request.pose),
                      checkWrench(robot, request.external_wrench),
                      checkPreferredTensions(robot, request.preferred_tensions));
}

RobotSolution solveInverse(const RobotDescription& robot, const InverseRequest& request,
                           const RobotSolverOptions& options) {
  const InverseSolve::Clock::time_point begin = InverseSolve::Clock::now();
  Status status = checkInverse(robot, request, options);
  if (!status.ok()) return refusedRobot(options.model, status);
  InverseSolve solve(robot, options);
  status = solve.solve(request, deadlineAfter(options.timeout));
  RobotSolution solution = status.ok() ? solve.solution() : refusedRobot(options.model, status);
  solution.report.solve_time = std::chrono::duration<double>(InverseSolve::Clock::now() - begin).count();
  return solution;
}

}  // namespace cdpr_kinetostatics

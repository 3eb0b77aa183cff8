#include "cdpr_kinetostatics/robot/forward.h"

#include "robot/forward_solve.h"
#include "robot/robot_checks.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {
Status checkForward(const RobotDescription& robot, const ForwardRequest& request, const RobotSolverOptions& options) {
  return firstRefusal(checkRobotOptions(options), checkLengths(robot, request.lengths),
                      checkWrench(robot, request.external_wrench),
                      request.seed ? checkPose("seed", *request.seed) : checkPose("home", robot.home));
}

RobotSolution solveForward(const RobotDescription& robot, const ForwardRequest& request,
                           const RobotSolverOptions& options) {
  const ForwardSolve::Clock::time_point begin = ForwardSolve::Clock::now();
  const Status check = firstRefusal(checkRobot(robot), checkForward(robot, request, options));
  if (!check.ok()) return refusedRobot(options.model, check);
  ForwardSolve solve(robot, options);
  solve.solve(request, deadlineAfter(options.timeout));
  RobotSolution solution = solve.solution();
  solution.report.solve_time = std::chrono::duration<double>(ForwardSolve::Clock::now() - begin).count();
  return solution;
}

}  // namespace cdpr_kinetostatics

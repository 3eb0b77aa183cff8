#include "cdpr_kinetostatics/robot/inverse.h"

#include "robot/inverse_solve.h"
#include "robot/robot_checks.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {

Status checkInverse(const RobotDescription& robot, const InverseRequest& request, const RobotSolverOptions& options) {
  return firstRefusal(checkRobotOptions(options), checkPose("pose", request.pose),
                      checkWrench(robot, request.external_wrench),
                      checkPreferredTensions(robot, request.preferred_tensions),
                      checkHoldYaw(robot, request.free_orientation && request.hold_yaw));
}

RobotSolution solveInverse(const RobotDescription& robot, const InverseRequest& request,
                           const RobotSolverOptions& options) {
  const InverseSolve::Clock::time_point begin = InverseSolve::Clock::now();
  const Status check = firstRefusal(checkRobot(robot), checkInverse(robot, request, options));
  if (!check.ok()) return refusedRobot(options.model, check);
  InverseSolve solve(robot, options);
  solve.solve(request, deadlineAfter(options.timeout));
  RobotSolution solution = solve.solution();
  solution.report.solve_time = std::chrono::duration<double>(InverseSolve::Clock::now() - begin).count();
  return solution;
}

}  // namespace cdpr_kinetostatics

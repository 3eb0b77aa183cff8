#include "cdpr_kinetostatics/robot/inverse.h"

#include <sstream>

#include "robot/inverse_solve.h"
#include "robot/platform_error.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {
namespace {

Status checkPreferred(const RobotDescription& robot, const std::vector<double>& preferred) {
  if (preferred.empty()) return {Code::kConverged, ""};
  std::ostringstream text;
  if (preferred.size() != robot.cables.size()) {
    text << preferred.size() << " preferred tensions were given for " << robot.cables.size() << " cables";
    return {Code::kInvalidInput, text.str()};
  }
  for (std::size_t i = 0; i < preferred.size(); ++i) {
    if (preferred[i] >= 0.0 && preferred[i] <= 1e12) continue;
    text << "preferred tension of cable '" << robot.cables[i].name << "' = " << preferred[i]
         << " N must be zero or positive and at most 1e12 N";
    return {Code::kInvalidInput, text.str()};
  }
  return {Code::kConverged, ""};
}

}  // namespace

Status checkInverse(const RobotDescription& robot, const InverseRequest& request, const RobotSolverOptions& options) {
  for (const Status& check :
       {checkRobotOptions(options), checkPose(request.pose), checkWrench(robot, request.external_wrench),
        checkPreferred(robot, request.preferred_tensions)}) {
    if (!check.ok()) return check;
  }
  return {Code::kConverged, ""};
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

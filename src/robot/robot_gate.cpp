#include "robot/robot_gate.h"

#include <algorithm>
#include <cmath>

#include "cable/cable_gate.h"
#include "cable/text.h"

namespace cdpr_kinetostatics {
namespace {

// Cables may be open, and forces out of balance, by so many times the tolerance's share of them: Newton's method judges
// by its step, and each of several cables adds its own.
constexpr double kShare = 10.0;

// Moments of a small platform come from cables that are as long as the span: its share is their arm, too.
constexpr double kShareOfSpan = 0.1;

// Positions are known to this share of themselves, ten roundings of a double. A stiff cable makes a force of it.
constexpr double kRounding = 1e-14;

// All forces that are summed, and what rounding of the pose makes of them [N].
double acceptedImbalance(const RobotDescription& robot, const RobotSolution& solution, const Wrench& external,
                         double tolerance) {
  double forces = robot.weight() + external.head<3>().norm() + external.tail<3>().norm() / robot.lever();
  double by_rounding = 0.0;
  const double size = robot.span() + solution.pose.position.norm();
  for (const CableResult& result : solution.cables) {
    const CableSolution& cable = result.cable;
    forces += std::max(cable.tension_a, cable.tension_b);
    const double stiffness = cable.force_jacobian.leftCols<2>().norm();
    if (std::isfinite(stiffness)) by_rounding += kRounding * size * stiffness;
  }
  return kShare * std::max(tolerance, kRounding) * forces + by_rounding;
}

bool isFinite(const RobotSolution& solution) {
  const RobotReport& report = solution.report;
  return solution.pose.position.allFinite() && solution.pose.orientation.coeffs().allFinite() &&
         std::isfinite(report.closure_residual) && std::isfinite(report.force_residual) &&
         std::isfinite(report.moment_residual) && std::isfinite(report.estimated_error) &&
         std::isfinite(report.estimated_rotation_error) && solution.stiffness.allFinite();
}

}  // namespace

Status balanceVerdict(const RobotDescription& robot, const RobotSolution& solution, const Wrench& external,
                      double tolerance, double solver_force) {
  const RobotReport& report = solution.report;
  const double force = acceptedImbalance(robot, solution, external, tolerance) + solver_force;
  const double moment = force * (robot.lever() + robot.com.norm() + kShareOfSpan * robot.span());
  if (report.force_residual <= force && report.moment_residual <= moment) return {Code::kConverged, ""};
  return {Code::kNotConverged, text("the tensions found do not balance the platform: ", report.force_residual,
                                    " N and ", report.moment_residual, " N m are left over")};
}

Status verdictOf(const RobotDescription& robot, const RobotSolution& solution, const Wrench& external, double tolerance,
                 double solver_force) {
  if (!isFinite(solution)) {
    return {Code::kNotConverged,
            "the robot's numbers do not fit into a double: its cables are too soft, too stiff or "
            "too light for its load"};
  }
  for (std::size_t i = 0; i < solution.cables.size(); ++i) {
    const CableResult& result = solution.cables[i];
    const CableSolution& cable = result.cable;
    const Status contact = contactOf(robot.cables[i].properties, cable);
    if (!contact.ok()) return {contact.code, text("cable '", result.name, "': ", contact.message)};
    if (!(cable.closure_residual <= kShare * acceptedClosure(cable, tolerance))) {
      return {Code::kNotConverged,
              text("cable '", result.name, "' ends ", cable.closure_residual, " m away from its attachment")};
    }
  }
  return balanceVerdict(robot, solution, external, tolerance, solver_force);
}

}  // namespace cdpr_kinetostatics

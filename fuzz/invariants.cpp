#include "invariants.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "robot_audit.h"

namespace cdpr_kinetostatics {
namespace {

// A converged answer may miss what it claims by so much of the length or of the forces: far more than any tolerance
// that the targets ask for, far less than an answer that is wrong.
constexpr double kMiss = 1e-5;
// Forces are known to this share; a compliant cable's end is known to as much times its compliance.
constexpr double kForceShare = 1e-7;

// The textbook catenary in extended precision; below this share of weight over tension its difference of two logarithms
// loses more digits than the series of both, 2 L/(T_A + T_B), leaves out.
constexpr long double kLight = 1e-6L;

Eigen::Vector2d catenaryEnd(const CableProperties& cable, const CableSolution& solution) {
  const long double h = solution.horizontal_force;
  const long double v = solution.vertical_force_a;
  const long double length = solution.length;
  const long double weight = static_cast<long double>(cable.weight) * length;
  const long double t_a = std::hypot(h, v);
  const long double t_b = std::hypot(h, v - weight);
  const long double stretch =
      isInextensible(solution.model) ? 0.0L : length / static_cast<long double>(cable.axial_stiffness);
  const bool light = weight <= kLight * std::max(t_a, t_b);
  const long double along =
      light ? 2.0L * length / (t_a + t_b) : length / weight * (std::asinh(v / h) - std::asinh((v - weight) / h));
  const long double x = h == 0.0L ? 0.0L : h * (stretch + along);
  const long double y = -(v - 0.5L * weight) * (stretch + 2.0L * length / (t_a + t_b));
  return {static_cast<double>(x), static_cast<double>(y)};
}

bool allFinite(const CableSolution& c) {
  bool finite = c.end_jacobian.allFinite() && c.force_jacobian.allFinite();
  for (const double value : {c.length, c.strained_length, c.x, c.y, c.horizontal_force, c.vertical_force_a, c.tension_a,
                             c.tension_b, c.angle_a, c.angle_b, c.sag, c.max_moment, c.max_shear, c.closure_residual,
                             c.moment_residual, c.estimated_error, c.least_tension}) {
    finite = finite && std::isfinite(value);
  }
  for (const ProfilePoint& p : c.profile) {
    for (const double value : {p.s, p.x, p.y, p.alpha, p.moment, p.tension, p.shear}) {
      finite = finite && std::isfinite(value);
    }
  }
  return finite;
}

void requireHonest(const Status& status) {
  require(status.code != Code::kUnset, "the outcome has no code", status);
  require(status.code != Code::kInternalError, "an internal error", status);
  require(status.ok() || !status.message.empty(), "a refusal without a sentence", status);
}

}  // namespace

void require(bool condition, const char* sentence, const Status& status) {
  if (condition) return;
  std::fprintf(stderr, "VIOLATED: %s (code %d: %s)\n", sentence, static_cast<int>(status.code), status.message.c_str());
  std::abort();
}

void requireHonest(const CableSolution& solution) {
  requireHonest(solution.status);
  require(allFinite(solution), "a cable's answer holds a NaN or an infinity", solution.status);
}

void requireClosed(const CableProperties& cable, const CableSolution& solution) {
  const Status& status = solution.status;
  if (!status.ok()) return;
  const double forces = std::max(solution.tension_a, solution.tension_b) + cable.weight * solution.length;
  const double allowed = kMiss * solution.length + kForceShare * solution.end_jacobian.leftCols<2>().norm() * forces;
  require(solution.closure_residual <= allowed, "CONVERGED, but the cable does not end where it should", status);
  require(solution.moment_residual <= kMiss * (solution.max_moment + forces * solution.length),
          "CONVERGED, but the moment jumps", status);
  Eigen::Vector2d end(solution.x, solution.y);
  const bool catenary = solution.model == Model::kCatenary || solution.model == Model::kCatenaryInextensible;
  const bool from_eyelet = cable.pulley.radius == 0.0 && cable.dead_length == 0.0;
  if (catenary && from_eyelet) {
    if (forces == 0.0) return;
    end = catenaryEnd(cable, solution);
  } else if ((catenary || isBending(solution.model)) && solution.horizontal_force > 0.0) {
    CableSolverOptions options;
    options.model = solution.model;
    const CableSolution again =
        findPosition(cable, solution.length, solution.horizontal_force, solution.vertical_force_a, options);
    if (again.status.ok()) end << again.x, again.y;
  }
  require((end - Eigen::Vector2d(solution.x, solution.y)).norm() <= allowed,
          "CONVERGED, but its forces take the cable elsewhere", status);
}

void requireHonest(const RobotDescription& robot, const Wrench& external, const RobotSolution& solution) {
  const Status& status = solution.report.status;
  requireHonest(status);
  const RobotReport& report = solution.report;
  bool finite = solution.pose.position.allFinite() && solution.pose.orientation.coeffs().allFinite() &&
                solution.stiffness.allFinite();
  for (const double value : {report.closure_residual, report.force_residual, report.moment_residual,
                             report.estimated_error, report.estimated_rotation_error, report.solve_time}) {
    finite = finite && std::isfinite(value);
  }
  for (const CableResult& cable : solution.cables) {
    finite = finite && allFinite(cable.cable) && cable.direction.allFinite() && cable.force_on_platform.allFinite();
    for (const Eigen::Vector3d& point : cable.profile) finite = finite && point.allFinite();
  }
  require(finite, "a robot's answer holds a NaN or an infinity", status);
  if (!status.ok()) return;
  require(solution.cables.size() == robot.cables.size(), "CONVERGED with cables missing", status);
  std::vector<PlaneForces> forces;
  double pull = robot.weight() + external.norm();
  for (const CableResult& cable : solution.cables) {
    forces.push_back({cable.cable.horizontal_force, cable.cable.vertical_force_a, cable.cable.free_length});
    pull += cable.cable.tension_a + cable.cable.tension_b;
    if (report.model != Model::kStraight) requireClosed(robot.cables[forces.size() - 1].properties, cable.cable);
  }
  const Wrench total = totalWrench(robot, external, solution.pose, forces);
  const bool least_squares = report.model == Model::kStraight && !status.message.empty();
  if (least_squares) return;
  require(total.head<3>().norm() <= kMiss * pull, "CONVERGED, but the forces do not balance", status);
  const double lever = robot.span() + solution.pose.position.norm();
  require(robot.freedoms() == 3 || total.tail<3>().norm() <= kMiss * pull * lever,
          "CONVERGED, but the moments do not balance", status);
}

void requireHonest(const RobotDescription& robot, const Estimate& estimate) {
  const Status& status = estimate.solution.report.status;
  requireHonest(status);
  require(estimate.covariance.allFinite() && estimate.load_covariance.allFinite() && estimate.load.allFinite(),
          "an estimate holds a NaN or an infinity", status);
  if (!status.ok()) return;
  require(estimate.solution.pose.position.allFinite(), "an estimated pose is not a number", status);
  for (Eigen::Index k = 0; k < 6; ++k) {
    require(estimate.covariance(k, k) >= 0.0, "a negative variance", status);
  }
  require(estimate.solution.cables.size() == robot.cables.size(), "CONVERGED with cables missing", status);
}

}  // namespace cdpr_kinetostatics

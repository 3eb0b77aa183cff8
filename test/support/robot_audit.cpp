#include "robot_audit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cable_equations.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "geometry/spatial.h"

namespace cdpr_kinetostatics {
namespace {

Eigen::Vector3d turned(const Eigen::Quaterniond& q, const Eigen::Vector3d& v) {
  const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
  return {(w * w + x * x - y * y - z * z) * v.x() + 2.0 * (x * y - w * z) * v.y() + 2.0 * (x * z + w * y) * v.z(),
          2.0 * (x * y + w * z) * v.x() + (w * w - x * x + y * y - z * z) * v.y() + 2.0 * (y * z - w * x) * v.z(),
          2.0 * (x * z - w * y) * v.x() + 2.0 * (y * z + w * x) * v.y() + (w * w - x * x - y * y + z * z) * v.z()};
}

Eigen::Vector3d crossed(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

}  // namespace

Eigen::Vector3d attachmentInWorld(const Pose& pose, const Eigen::Vector3d& attachment) {
  return pose.position + turned(pose.orientation, attachment);
}

Wrench totalWrench(const RobotDescription& robot, const Wrench& external, const Pose& pose,
                   const std::vector<PlaneForces>& forces) {
  const Eigen::Vector3d weight(0.0, 0.0, -robot.mass * robot.gravity);
  Eigen::Vector3d force = weight + external.head<3>();
  Eigen::Vector3d moment = crossed(turned(pose.orientation, robot.com), weight) + external.tail<3>();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const CableDescription& cable = robot.cables[i];
    const Eigen::Vector3d b = attachmentInWorld(pose, cable.attachment);
    const Eigen::Vector3d to_b = b - cable.anchor;
    const double x = std::sqrt(to_b.x() * to_b.x() + to_b.y() * to_b.y());
    const Eigen::Vector3d f(x > 0.0 ? -forces[i].h * to_b.x() / x : -forces[i].h,
                            x > 0.0 ? -forces[i].h * to_b.y() / x : 0.0,
                            forces[i].v - cable.properties.weight * forces[i].length);
    force += f;
    moment += crossed(b - pose.position, f);
  }
  Wrench total;
  total << force, moment;
  return total;
}

Eigen::Vector2d textbookCatenaryEnd(const CableProperties& cable, const PlaneForces& f) {
  const double q = cable.weight;
  const double end = f.v - q * f.length;
  const double stretch = f.length / cable.axial_stiffness;
  return {f.h * stretch + f.h / q * (std::asinh(f.v / f.h) - std::asinh(end / f.h)),
          -(f.v - 0.5 * q * f.length) * stretch + (std::hypot(f.h, end) - std::hypot(f.h, f.v)) / q};
}

RobotAudit audit(const RobotDescription& robot, const Wrench& external, const RobotSolution& solution) {
  RobotAudit result;
  std::vector<PlaneForces> forces;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CableDescription& description = robot.cables[i];
    const CableSolution& cable = solution.cables[i].cable;
    forces.push_back({cable.horizontal_force, cable.vertical_force_a, cable.length});
    const Eigen::Vector3d to_b = attachmentInWorld(solution.pose, description.attachment) - description.anchor;
    const Eigen::Vector2d b(std::hypot(to_b.x(), to_b.y()), to_b.z());
    Eigen::Vector2d end;
    CableProperties seen = description.properties;
    if (isInextensible(cable.model)) seen.axial_stiffness = std::numeric_limits<double>::infinity();
    if (isCatenary(cable.model) && cable.model != Model::kCatenaryCorrected) {
      end = textbookCatenaryEnd(seen, forces.back());
    } else {
      CableSolverOptions options;
      options.model = cable.model;
      options.tolerance = 1e-11;
      const CableSolution position =
          findPosition(description.properties, cable.length, forces.back().h, forces.back().v, options);
      end << position.x, position.y;
      if (!position.status.ok()) end.setConstant(std::numeric_limits<double>::infinity());
    }
    result.closure = std::max(result.closure, (end - b).norm());
    const double tension = std::sqrt(forces.back().h * forces.back().h + forces.back().v * forces.back().v);
    result.below_limit = std::max(result.below_limit, 1.0 - tension / description.tension_min);
    result.above_limit = std::max(result.above_limit, tension / description.tension_max - 1.0);
  }
  const Wrench total = totalWrench(robot, external, solution.pose, forces);
  result.force = total.head<3>().norm() / robot.weight();
  result.moment =
      robot.type == PlatformType::kPointMass ? 0.0 : total.tail<3>().norm() / (robot.weight() * robot.span());
  return result;
}

double largestProfileDefect(const RobotDescription& robot, const RobotSolution& solution, int steps) {
  double largest = 0.0;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CableSolution& cable = solution.cables[i].cable;
    const CableProperties& properties = robot.cables[i].properties;
    for (std::size_t k = 0; k + 1 < cable.profile.size(); ++k) {
      const ProfilePoint& from = cable.profile[k];
      const ProfilePoint& to = cable.profile[k + 1];
      const CableState<double> end =
          integrateCable<double>(properties, cable.horizontal_force, cable.vertical_force_a, from.s, to.s,
                                 {from.alpha, from.moment, from.x, from.y}, steps);
      largest = std::max(largest, std::hypot(end[2] - to.x, end[3] - to.y));
    }
    const Eigen::Vector3d to_b = attachmentInWorld(solution.pose, robot.cables[i].attachment) - robot.cables[i].anchor;
    const ProfilePoint& last = cable.profile.back();
    largest = std::max(largest, std::hypot(last.x - std::hypot(to_b.x(), to_b.y()), last.y - to_b.z()));
  }
  return largest;
}

double largestStiffness(const RobotDescription& robot, const RobotSolution& solution, Model model) {
  CableSolverOptions options;
  options.model = model;
  options.tolerance = 1e-10;
  bool solved = true;
  const auto wrenchAt = [&](const Pose& pose) {
    std::vector<PlaneForces> forces;
    for (std::size_t i = 0; i < robot.cables.size(); ++i) {
      const Eigen::Vector3d to_b = attachmentInWorld(pose, robot.cables[i].attachment) - robot.cables[i].anchor;
      const double length = solution.cables[i].cable.length;
      const CableSolution cable =
          findForces(robot.cables[i].properties, length, to_b.head<2>().norm(), to_b.z(), options);
      solved = solved && cable.status.ok();
      forces.push_back({cable.horizontal_force, cable.vertical_force_a, length});
    }
    return totalWrench(robot, Wrench::Zero(), pose, forces);
  };
  constexpr double kStep = 1e-5;
  Eigen::Matrix<double, 6, 6> stiffness;
  for (int k = 0; k < 6; ++k) {
    const Wrench step = kStep * Wrench::Unit(k);
    stiffness.col(k) = (wrenchAt(displaced(solution.pose, step.head<3>(), step.tail<3>())) -
                        wrenchAt(displaced(solution.pose, -step.head<3>(), -step.tail<3>()))) /
                       (2.0 * kStep);
  }
  if (!solved) return std::numeric_limits<double>::quiet_NaN();
  const Eigen::Matrix<double, 6, 6> symmetric = 0.5 * (stiffness + stiffness.transpose());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(symmetric).eigenvalues()(5);
}

}  // namespace cdpr_kinetostatics

#include "robot_cases.h"

#include <cmath>
#include <stdexcept>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "finite_solution.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {

double Dice::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(generator_()) / 4294967296.0);
}

double Dice::normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));  // Box and Muller
  return radius * std::cos(uniform(0.0, 2.0 * M_PI));
}

Eigen::Vector3d Dice::inBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  Eigen::Vector3d point;
  for (int k = 0; k < 3; ++k) point(k) = uniform(low(k), high(k));
  return point;
}

Eigen::Vector3d Dice::direction() {
  for (;;) {
    const Eigen::Vector3d v = inBox(Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Ones());
    if (v.norm() < 1.0 && v.norm() > 0.1) return v.normalized();
  }
}

Eigen::Quaterniond Dice::attitude() { return Eigen::Quaterniond(Eigen::AngleAxisd(uniform(0.0, 3.1), direction())); }

Pose Dice::away(const Pose& pose, double distance, double angle) {
  const Eigen::Vector3d translation = distance * direction();
  return displaced(pose, translation, angle * direction());
}

std::vector<Workspace> shippedWorkspaces() {
  return {
      {"cogiro", {-2.2, -1.6, 0.5}, {2.2, 1.6, 2.5}, 0.1},
      {"caroca", {-1.0, -0.6, 0.7}, {1.0, 0.6, 1.7}, 0.1},
      {"ipanema3", {-2.4, -1.6, 0.8}, {2.4, 1.6, 1.8}, 0.1},
      {"desktop_music_wire", {0.3, 0.28, 0.5}, {0.5, 0.48, 0.7}, 0.1},
      // Six ropes leave no tension free: a cabin off the axis or out of level has ropes below their limit.
      {"fast", {-7.0, -7.0, 135.0}, {7.0, 7.0, 145.0}, 0.003},
      {"scampi", {-0.3, -3.5, 2.0}, {1.0, 0.0, 5.0}, 0.1},
      // Two bars in one plane hold the mass in that plane only.
      {"paper_point_mass", {2.0, 0.0, -3.0}, {8.0, 0.0, -0.5}, 0.0},
  };
}

Workspace workspaceOf(const std::string& robot) {
  for (const Workspace& workspace : shippedWorkspaces()) {
    if (workspace.robot == robot) return workspace;
  }
  throw std::invalid_argument("no workspace for robot " + robot);
}

Pose randomPose(const Workspace& workspace, Dice* dice) {
  Pose pose;
  pose.position = dice->inBox(workspace.low, workspace.high);
  const double angle = dice->uniform(0.0, workspace.tilt);
  pose.orientation = Eigen::AngleAxisd(angle, dice->direction());
  return pose;
}

RobotDescription shippedRobot(const std::string& robot_directory, const std::string& name) {
  return loadRobotFile(robot_directory + "/" + name + ".yaml").robot;
}

RobotSolverOptions patient(Model model, double tolerance) {
  RobotSolverOptions options;
  options.model = model;
  options.tolerance = tolerance;
  options.timeout = std::chrono::duration<double>(30.0);
  return options;
}

InverseRequest requestFor(const RobotDescription& robot, const Pose& pose) {
  InverseRequest request;
  request.pose = pose;
  request.free_orientation =
      robot.type == PlatformType::kRigidBody && static_cast<int>(robot.cables.size()) < robot.freedoms();
  return request;
}

RobotSolution forward(const RobotDescription& robot, const std::vector<double>& lengths, const Pose& seed,
                      const RobotSolverOptions& options) {
  ForwardRequest request;
  request.lengths = lengths;
  request.seed = seed;
  return solveForward(robot, request, options);
}

bool samePose(const Pose& a, const Pose& b, double tolerance) {
  return (a.position - b.position).norm() < tolerance && a.orientation.angularDistance(b.orientation) < tolerance;
}

bool isFinite(const RobotSolution& solution) {
  const RobotReport& r = solution.report;
  bool finite = solution.pose.position.allFinite() && solution.pose.orientation.coeffs().allFinite() &&
                solution.stiffness.allFinite() && std::isfinite(r.solve_time) && std::isfinite(r.closure_residual) &&
                std::isfinite(r.force_residual) && std::isfinite(r.moment_residual);
  for (const CableResult& result : solution.cables) {
    finite = finite && result.direction.allFinite() && result.force_on_platform.allFinite() && isFinite(result.cable);
    for (const Eigen::Vector3d& point : result.profile) finite = finite && point.allFinite();
  }
  return finite;
}

}  // namespace cdpr_kinetostatics

#include "robot/straight_forward.h"

#include <algorithm>
#include <cmath>

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/robot/tension_distribution.h"
#include "robot/platform_statics.h"
#include "robot/solution_assembly.h"
#include "robot/spring_platform.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMaxMultiplierUpdates = 60;

// Least-squares pose, then the tensions that balance best.
Status solveOverdetermined(const RobotDescription& robot, const ForwardRequest& request, double tolerance,
                           Clock::time_point deadline, Pose* pose, std::vector<double>* tensions, int* iterations) {
  std::vector<Spring> springs;
  const double stiffness = robot.weight() / robot.span();
  for (const double length : request.lengths) springs.push_back({stiffness, length, 0.0, true});
  const Status status = SpringPlatform(robot, nullptr).descend(springs, tolerance, deadline, pose, iterations);
  if (!status.ok()) return status;
  const int n = robot.freedoms();
  const double radius = n == 6 ? robot.lever() : 1.0;
  Wrench rows;
  rows << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / radius);
  Wrench needed = -loadWrench(robot, *pose, request.external_wrench);
  Eigen::MatrixXd structure(6, robot.cables.size());
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const Eigen::Vector3d arm = pose->orientation * robot.cables[i].attachment;
    const Eigen::Vector3d along = anchorToAttachment(robot.cables[i], *pose);
    structure.col(static_cast<Eigen::Index>(i)) = wrenchAt(arm, -along.normalized());
    const double half_weight = 0.5 * robot.cables[i].properties.weight * request.lengths[i];
    needed += wrenchAt(arm, half_weight * Eigen::Vector3d::UnitZ());
  }
  const Eigen::VectorXd solution =
      nonNegativeTensions((rows.asDiagonal() * structure).topRows(n), (rows.asDiagonal() * needed).head(n));
  tensions->assign(solution.data(), solution.data() + solution.size());
  return status;
}

// Springs as stiff as the cables, whose shifts grow until no cable is longer than it should be.
Status solveInextensible(const RobotDescription& robot, const ForwardRequest& request, double tolerance,
                         Clock::time_point deadline, std::vector<Spring>* springs, Pose* pose, int* iterations) {
  const SpringPlatform platform(robot, &request.external_wrench);
  for (int i = 0; i < kMaxMultiplierUpdates; ++i) {
    const Status status = platform.descend(*springs, tolerance, deadline, pose, iterations);
    if (!status.ok()) return status;
    double excess = 0.0;
    for (std::size_t k = 0; k < springs->size(); ++k) {
      Spring& spring = (*springs)[k];
      const double chord = anchorToAttachment(robot.cables[k], *pose).norm();
      const double tension = spring.tension(chord);
      if (tension > 0.0) excess = std::max(excess, std::abs(chord / spring.length - 1.0));
      spring.shift = tension;
    }
    if (excess < 1e-12) return status;
  }
  return {Code::kNotConverged, "the inextensible cables' tensions did not settle"};
}

}  // namespace

RobotSolution solveStraightForward(const RobotDescription& robot, const ForwardRequest& request,
                                   const RobotSolverOptions& options, Clock::time_point deadline) {
  RobotSolution solution;
  solution.pose = request.seed.value_or(robot.home);
  int& iterations = solution.report.iterations;
  std::vector<Spring> springs;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    springs.push_back({robot.cables[i].properties.axial_stiffness / request.lengths[i], request.lengths[i]});
  }
  std::vector<double> tensions;
  Status status;
  if (options.model == Model::kStraightElastic) {
    status = SpringPlatform(robot, &request.external_wrench)
                 .descend(springs, options.tolerance, deadline, &solution.pose, &iterations);
  } else if (static_cast<int>(robot.cables.size()) > robot.freedoms()) {
    status = solveOverdetermined(robot, request, options.tolerance, deadline, &solution.pose, &tensions, &iterations);
  } else {
    status = solveInextensible(robot, request, options.tolerance, deadline, &springs, &solution.pose, &iterations);
  }
  if (!status.ok()) return refusedRobot(options.model, status);

  std::vector<CableSolution> cables;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot.cables[i], solution.pose);
    const double chord = std::hypot(plane.x, plane.y);
    const double tension = tensions.empty() ? springs[i].tension(chord) : tensions[i];
    const double half_weight = 0.5 * robot.cables[i].properties.weight * request.lengths[i];
    SaggingCable line(robot.cables[i].properties, options.model, options.tolerance);
    line.start(request.lengths[i], {tension * plane.x / chord, half_weight - tension * plane.y / chord});
    CableSolution cable = line.describe(plane.x, plane.y, options.profile_points);
    if (!tensions.empty()) cable.closure_residual = std::abs(chord - request.lengths[i]);
    cables.push_back(cable);
  }
  solution.report.status = status;
  assemble(robot, request.external_wrench, cables, &solution);
  if (options.compute_stiffness && tensions.empty()) {
    solution.stiffness = SpringPlatform(robot, &request.external_wrench).at(solution.pose, springs).stiffness;
  }
  return solution;
}

}  // namespace cdpr_kinetostatics

#include "estimation/homing.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "cable/text.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

// Where the attitude is left to equilibrium, the one given may differ from it by this [rad]: a spirit level's error is
// far below, another equilibrium far above.
constexpr double kAsSaid = 0.05;

// Below this share of the weight a component of the wrench has no deviation: it is known.
constexpr double kLeastShare = 1e-9;

// d(H, V, L)/d(T_A) between fixed ends. Lines that do not stretch have no such derivative of their length: it is 0.
Eigen::Vector3d byTension(const CableSolution& cable) {
  Eigen::Matrix3d system;
  system << cable.end_jacobian, cable.horizontal_force / cable.tension_a, cable.vertical_force_a / cable.tension_a, 0.0;
  const Eigen::Vector3d by_tension = system.fullPivLu().solve(Eigen::Vector3d::UnitZ());
  if (by_tension.allFinite() && cable.model != Model::kStraight) return by_tension;
  return {cable.horizontal_force / cable.tension_a, cable.vertical_force_a / cable.tension_a, 0.0};
}

double averaged(double stddev, std::size_t samples) { return stddev / std::sqrt(static_cast<double>(samples)); }

// What is left over of the platform's balance, and what deviations of tensions and load explain of it.
struct Balance {
  Wrench left;
  Eigen::Matrix<double, 6, 6> covariance;

  void add(const CablePlane& plane, const CableProperties& properties, const CableSolution& cable, double stddev) {
    left += wrenchAt(plane.arm, forceAtB(plane, cable.horizontal_force, cable.vertical_force_b));
    const Eigen::Vector3d change = byTension(cable);
    const Wrench by_tension =
        wrenchAt(plane.arm, forceAtB(plane, change.x(), change.y() - properties.weight * change.z()));
    covariance += stddev * stddev * by_tension * by_tension.transpose();
  }
};

// A load cell's error is no noise that averages out: each tension counts with its full deviation.
Status checkBalance(const RobotDescription& robot, const EstimatorOptions& options, const Balance& balance,
                    RobotReport* report) {
  const Eigen::Index n = robot.freedoms();
  report->force_residual = balance.left.head<3>().norm();
  report->moment_residual = n == 6 ? balance.left.tail<3>().norm() : 0.0;
  if (!options.known_load) return {Code::kConverged, ""};
  const Eigen::MatrixXd covariance = balance.covariance.topLeftCorner(n, n);
  const Eigen::VectorXd left = balance.left.head(n);
  const double sigmas = std::sqrt(left.dot(covariance.ldlt().solve(left)));
  if (sigmas <= options.outlier_threshold) return {Code::kConverged, ""};
  return {
      Code::kInvalidInput,
      text("the measured tensions contradict this pose: ", report->force_residual, " N and ", report->moment_residual,
           " N m are left over, ", sigmas, " standard deviations where at most ", options.outlier_threshold,
           " are expected: check the pose, the zeros of the load cells, and that nothing else holds or loads the "
           "platform")};
}

Status lengthsFromTensions(const RobotDescription& robot, const EstimatorOptions& options,
                           const RestingSamples& samples, Homing* homing) {
  CableSolverOptions of_cable;
  of_cable.model = options.model;
  of_cable.accuracy = options.accuracy;
  of_cable.tolerance = options.tolerance;
  of_cable.timeout = options.timeout;
  const double least = kLeastShare * robot.weight();
  Balance balance{loadWrench(robot, homing->pose, Wrench::Zero()), {}};
  balance.covariance = (options.load_stddev.array() + least).square().matrix().asDiagonal();
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CableDescription& description = robot.cables[i];
    const CablePlane plane = cablePlane(description, homing->pose);
    const CableSolution cable =
        findLength(description.properties, plane.x, plane.y, samples.meanTension(i), 0.0, of_cable);
    if (!cable.status.ok()) {
      return {cable.status.code,
              text("cable '", description.name, "' at its measured tension: ", cable.status.message)};
    }
    homing->report.model = std::max(homing->report.model, cable.model);
    homing->corrections.push_back(cable.length - samples.meanLength(i));
    homing->stddev.push_back(
        std::hypot(averaged(options.length_stddev, samples.lengthCount(i)),
                   byTension(cable).z() * averaged(options.tension_stddev, samples.tensionCount(i))));
    balance.add(plane, description.properties, cable, options.tension_stddev);
  }
  return checkBalance(robot, options, balance, &homing->report);
}

Status lengthsFromEquilibrium(const RobotDescription& robot, const EstimatorOptions& options,
                              const RestingSamples& samples, Homing* homing) {
  const auto freedoms = static_cast<std::size_t>(robot.freedoms());
  if (robot.cables.size() > freedoms) {
    return {Code::kInvalidInput,
            text("use_tensions is false: ", robot.name, " has ", robot.cables.size(), " cables for ", freedoms,
                 " freedoms, so its pose says nothing of how tight they are, and their lengths depend on that: "
                 "measure the tensions and set use_tensions")};
  }
  InverseRequest request;
  request.pose = homing->pose;
  request.free_orientation = robot.type == PlatformType::kRigidBody && robot.cables.size() < freedoms;
  RobotSolverOptions solver;
  solver.model = options.model;
  solver.accuracy = options.accuracy;
  solver.tolerance = options.tolerance;
  solver.timeout = options.timeout;
  const RobotSolution solution = solveInverse(robot, request, solver);
  homing->report = solution.report;
  if (!solution.report.status.ok()) return solution.report.status;
  const double turned = solution.pose.orientation.angularDistance(homing->pose.orientation);
  if (turned > kAsSaid) {
    return {Code::kInvalidInput, text("the platform would not hang like this: at that position its equilibrium is "
                                      "turned by ",
                                      turned, " rad from the attitude given, expected at most ", kAsSaid)};
  }
  homing->pose = solution.pose;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    homing->corrections.push_back(solution.cables[i].cable.length - samples.meanLength(i));
    homing->stddev.push_back(averaged(options.length_stddev, samples.lengthCount(i)));
  }
  return {Code::kConverged, ""};
}

}  // namespace

Homing findHome(const RobotDescription& robot, const EstimatorOptions& options, const HomingRequest& request,
                const RestingSamples& samples) {
  Homing homing;
  homing.pose = request.pose;
  homing.report.status = samples.checkRest(robot, request.use_tensions, options.length_stddev, options.tension_stddev);
  if (homing.report.status.ok()) {
    homing.report.status = request.use_tensions ? lengthsFromTensions(robot, options, samples, &homing)
                                                : lengthsFromEquilibrium(robot, options, samples, &homing);
  }
  if (!homing.report.status.ok()) {
    homing.corrections.clear();
    homing.stddev.clear();
  }
  return homing;
}

}  // namespace cdpr_kinetostatics

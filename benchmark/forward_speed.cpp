// How fast is a robot's warm forward solve by BENDING? Measured in a unit that does not depend on the machine: one bare
// RK45 pass along the same cables (docs/performance.md).
//
//     forward_speed [--quick] [--csv FILE]
//
// Each robot moves along a closed curve through its workspace in steps of 10 mm; lengths come from the inverse
// beforehand. Every step times each contender once, so that all see the same disturbances; medians are compared.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/robot/forward_follower.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"
#include "support/bare_integration.h"
#include "support/benchmark_report.h"
#include "support/workspace_path.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-8;
constexpr double kNodeSpacing = 3.0;  // bending layers between restarts of the bare pass

struct PathPoint {
  ForwardRequest request;
  Pose pose;
  std::vector<KnownCable> cables;
};

KnownCable known(const CableDescription& description, const CableSolution& cable, const CableSolverOptions& options) {
  KnownCable result{description.properties, cable.length, cable.horizontal_force, cable.vertical_force_a, {}};
  CableSolverOptions with_profile = options;
  with_profile.profile_points = nodesFor(result, kNodeSpacing);
  result.nodes = findForces(description.properties, cable.length, cable.x, cable.y, with_profile).profile;
  return result;
}

std::vector<PathPoint> pathOf(const RobotDescription& robot, const Workspace& workspace, int steps) {
  std::vector<PathPoint> path;
  for (int i = 0; i <= steps; ++i) {
    const Pose pose = poseOnPath(workspace, kPathStep * i);
    const RobotSolution solution = solveInverse(robot, requestFor(robot, pose), patient(Model::kBending, kTolerance));
    if (!solution.report.status.ok()) {
      throw std::runtime_error(robot.name + ": the path leaves the workspace: " + solution.report.status.message);
    }
    PathPoint point;
    point.request.lengths = lengthsOf(solution);
    point.pose = solution.pose;
    CableSolverOptions options;
    options.tolerance = kTolerance;
    for (std::size_t k = 0; k < robot.cables.size(); ++k) {
      point.cables.push_back(known(robot.cables[k], solution.cables[k].cable, options));
    }
    path.push_back(std::move(point));
  }
  return path;
}

struct Row {
  std::string robot;
  double layers_low = 0.0, layers_high = 0.0;  // kappa L
  double warm = 0.0;                           // [s], medians
  double bare = 0.0;
  double warm_starts = 0.0;     // share
  double linearisations = 0.0;  // of a solve, mean
  double bare_steps = 0.0;      // per pass, mean
  double pose_error = 0.0;      // largest distance from the inverse's pose [m]
  double bare_error = 0.0;      // largest distance of a bare pass' end from the cable's, relative to its length
};

Row measure(const std::string& name, int steps) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
  const std::vector<PathPoint> path = pathOf(robot, workspaceOf(name), steps);
  ForwardFollower follower(robot, patient(Model::kBending, kTolerance));
  follower.solve(path.front().request);

  Row row;
  row.robot = name;
  row.layers_low = std::numeric_limits<double>::infinity();
  std::vector<double> warm, bare;
  for (std::size_t i = 1; i < path.size(); ++i) {
    double begin = now();
    const Status& status = follower.solve(path[i].request);
    warm.push_back(now() - begin);
    if (!status.ok()) throw std::runtime_error(name + ": " + status.message);
    row.warm_starts += follower.warmStarted() ? 1.0 / steps : 0.0;
    row.linearisations += follower.iterations() / static_cast<double>(steps);
    row.pose_error = std::max(row.pose_error, (follower.pose().position - path[i].pose.position).norm());

    begin = now();
    std::vector<BarePass> passes;
    for (const KnownCable& cable : path[i].cables) passes.push_back(integrateBare(cable, kTolerance));
    bare.push_back(now() - begin);
    for (std::size_t k = 0; k < passes.size(); ++k) {
      const KnownCable& cable = path[i].cables[k];
      row.bare_steps += passes[k].steps / static_cast<double>(steps);
      const double error = std::hypot(passes[k].x - cable.nodes.back().x, passes[k].y - cable.nodes.back().y);
      row.bare_error = std::max(row.bare_error, error / cable.length);
      row.layers_low = std::min(row.layers_low, layersOf(cable));
      row.layers_high = std::max(row.layers_high, layersOf(cable));
    }
  }
  row.warm = quantile(warm, 0.5);
  row.bare = quantile(bare, 0.5);
  return row;
}

// Names of quantities carry the robot's.
void add(const Row& row, double target, BenchmarkReport* report) {
  const auto named = [&](const std::string& text) { return row.robot + ": " + text; };
  const std::string ratio = named("forward BENDING warm / bare RK45 pass");
  if (target > 0.0) {
    report->atMost(1, ratio, row.warm / row.bare, target);
  } else {
    report->figure(1, ratio, row.warm / row.bare, "");
  }
  report->figure(1, named("forward BENDING warm"), 1e6 * row.warm, "us");
  report->figure(1, named("linearisations of a warm solve"), row.linearisations, "");
  report->figure(1, named("share of solves that started warm"), row.warm_starts, "");
  report->figure(1, named("bare RK45 pass over all cables"), 1e6 * row.bare, "us");
  report->figure(1, named("steps of the bare pass"), row.bare_steps, "");
  report->figure(1, named("least kappa L"), row.layers_low, "");
  report->figure(1, named("largest kappa L"), row.layers_high, "");
  report->figure(1, named("largest difference of forward and inverse"), row.pose_error, "m");
  report->figure(1, named("largest error of the bare pass, relative"), row.bare_error, "");
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  using namespace cdpr_kinetostatics;
  BenchmarkReport report(argc, argv);
  const int steps = report.quick() ? 40 : 400;
  for (const Workspace& workspace : shippedWorkspaces()) {
    const double target = workspace.robot == "cogiro" ? 0.6 : workspace.robot == "desktop_music_wire" ? 4.0 : 0.0;
    add(measure(workspace.robot, steps), target, &report);
  }
  return report.finish();
}

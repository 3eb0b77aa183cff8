// How fast are warm solves of CoGiRo by AUTO at 1e-4 m? Forward against BENDING and against one Ceres solve of the same
// size whose residuals cost nothing; inverse and estimate against forward (docs/performance.md).
//
//     auto_speed [--quick] [--csv FILE]
//
// The robot moves along a closed curve through its workspace in steps of 10 mm; lengths come from the inverse
// beforehand, measurements carry noise of 1 mm and 5 N. Every step times each contender once, so that all see the same
// disturbances; medians are compared.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "cdpr_kinetostatics/robot/forward_follower.h"
#include "cdpr_kinetostatics/robot/inverse_follower.h"
#include "robot_cases.h"
#include "support/benchmark_report.h"
#include "support/ceres_yardstick.h"
#include "support/workspace_path.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

constexpr char kRobot[] = "cogiro";
constexpr double kTolerance = 1e-8;
constexpr double kAccuracy = 1e-4;  // [m]
constexpr int kYardstickIterations = 3;
// What the estimate asks of Ceres: 14 unknowns, the pose and one density per cable.
constexpr int kEstimatePairs = 4;
constexpr int kEstimateIterations = 4;

struct PathPoint {
  InverseRequest inverse;
  ForwardRequest forward;
  CableMeasurements measured;
};

RobotSolverOptions byAuto() {
  RobotSolverOptions options = patient(Model::kAuto, kTolerance);
  options.accuracy = kAccuracy;
  return options;
}

EstimatorOptions estimatorOf(const RobotDescription& robot) {
  EstimatorOptions options;
  options.model = Model::kAuto;
  options.accuracy = kAccuracy;
  options.tolerance = kTolerance;
  options.timeout = std::chrono::seconds(10);
  options.load_stddev = EstimatorOptions::defaultLoadStddev(robot);
  return options;
}

std::vector<PathPoint> pathOf(const RobotDescription& robot, const Workspace& workspace, int steps) {
  const EstimatorOptions noise;
  Dice dice(31);
  std::vector<PathPoint> path;
  for (int i = 0; i <= steps; ++i) {
    PathPoint point;
    point.inverse = requestFor(robot, poseOnPath(workspace, kPathStep * i));
    const RobotSolution solution = solveInverse(robot, point.inverse, patient(Model::kBending, kTolerance));
    if (!solution.report.status.ok()) {
      throw std::runtime_error(robot.name + ": the path leaves the workspace: " + solution.report.status.message);
    }
    point.forward.lengths = lengthsOf(solution);
    for (const CableResult& result : solution.cables) {
      point.measured.lengths.emplace_back(result.cable.length + noise.length_stddev * dice.normal());
      point.measured.tensions.emplace_back(result.cable.tension_a + noise.tension_stddev * dice.normal());
    }
    path.push_back(point);
  }
  return path;
}

void mustBeOk(const std::string& what, const Status& status) {
  if (!status.ok()) throw std::runtime_error(what + ": " + status.message);
}

// One contender: times of its solves and how many of them were warm.
struct Timed {
  std::vector<double> times;  // [s]
  int warm = 0;

  template <typename Solve>
  void time(const Solve& solve) {
    const double begin = now();
    const bool was_warm = solve();
    times.push_back(now() - begin);
    warm += was_warm ? 1 : 0;
  }
  double median() const { return quantile(times, 0.5); }
  double warmShare() const { return warm / static_cast<double>(times.size()); }
};

struct Contenders {
  Timed bending, automatic, yardstick, inverse, estimate, estimate_yardstick;
  double distance = 0.0;  // largest one of AUTO's pose from BENDING's [m]
};

Contenders measure(int steps) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, kRobot);
  const std::vector<PathPoint> path = pathOf(robot, workspaceOf(kRobot), steps);
  CeresYardstick yardstick(static_cast<int>(robot.cables.size()), kYardstickIterations);
  CeresYardstick estimate_yardstick(kEstimatePairs, kEstimateIterations);
  ForwardFollower bending(robot, patient(Model::kBending, kTolerance));
  ForwardFollower automatic(robot, byAuto());
  InverseFollower inverse(robot, byAuto());
  PoseEstimator estimator(robot, estimatorOf(robot));
  Contenders c;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i < 2) c = {};  // the first solves are cold
    const PathPoint& point = path[i];
    c.bending.time([&] {
      mustBeOk("forward", bending.solve(point.forward));
      return bending.warmStarted();
    });
    c.automatic.time([&] {
      mustBeOk("forward", automatic.solve(point.forward));
      return automatic.warmStarted();
    });
    c.distance = std::max(c.distance, (automatic.pose().position - bending.pose().position).norm());
    c.yardstick.time([&] {
      keep(yardstick.solve());
      return true;
    });
    c.inverse.time([&] {
      mustBeOk("inverse", inverse.solve(point.inverse));
      return inverse.warmStarted();
    });
    c.estimate.time([&] {
      const Estimate estimate = estimator.update(point.measured);
      mustBeOk("estimate", estimate.solution.report.status);
      return estimate.warm_started;
    });
    c.estimate_yardstick.time([&] {
      keep(estimate_yardstick.solve());
      return true;
    });
  }
  return c;
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  using namespace cdpr_kinetostatics;
  BenchmarkReport report(argc, argv);
  const Contenders c = measure(report.quick() ? 100 : 1000);
  const double forward = c.automatic.median();
  report.atMost(2, "forward AUTO / forward BENDING, warm", forward / c.bending.median(), 0.5);
  report.atMost(2, "forward AUTO / Ceres DENSE_QR, same size, free evaluations", forward / c.yardstick.median(), 2.5);
  report.figure(2, "forward AUTO warm", 1e6 * forward, "us");
  report.figure(2, "share of forward solves that started warm", c.automatic.warmShare(), "");
  report.figure(2, "forward BENDING warm", 1e6 * c.bending.median(), "us");
  report.figure(2, "Ceres DENSE_QR, same size, free evaluations", 1e6 * c.yardstick.median(), "us");
  report.figure(2, "largest distance of AUTO from BENDING", c.distance, "m");
  report.atMost(3, "inverse AUTO / forward AUTO, warm", c.inverse.median() / forward, 3.0);
  report.atMost(3, "estimate AUTO / forward AUTO, warm", c.estimate.median() / forward, 2.0);
  report.figure(3, "inverse AUTO warm", 1e6 * c.inverse.median(), "us");
  report.figure(3, "share of inverse solves that started warm", c.inverse.warmShare(), "");
  report.figure(3, "estimate AUTO", 1e6 * c.estimate.median(), "us");
  report.figure(3, "Ceres DENSE_QR, 14 unknowns, 4 iterations, free evaluations", 1e6 * c.estimate_yardstick.median(),
                "us");
  report.figure(3, "estimate AUTO / forward BENDING, warm", c.estimate.median() / c.bending.median(), "");
  return report.finish();
}

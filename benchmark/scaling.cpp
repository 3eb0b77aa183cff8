// How the time of a solve grows with the number of cables, with kappa L, and with the accuracy asked for
// (docs/performance.md, item 7).
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "known_cables.h"
#include "robot_cases.h"
#include "support/benchmark_report.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

template <typename Job>
double medianTime(int rounds, const Job& job) {
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) {
    const double begin = now();
    job();
    times.push_back(now() - begin);
  }
  return quantile(times, 0.5);
}

// A suspended platform on rings of four CoGiRo ropes, each ring turned against the one before; the attachments of
// every other ring are crossed and on the platform's other face, so that eight cables and more hold all six freedoms.
RobotDescription robotOfRings(int rings) {
  RobotDescription robot;
  robot.name = "rings";
  robot.mass = 100.0 * rings;
  robot.home.position.z() = 1.5;
  for (int ring = 0; ring < rings; ++ring) {
    const double turned = 0.5 * kPi * ring / rings;
    const double crossed = ring % 2 == 0 ? 0.0 : kPi / 3.0;
    for (int k = 0; k < 4; ++k) {
      const double at = 0.25 * kPi + 0.5 * kPi * k + turned;
      CableDescription cable;
      cable.name = "cable" + std::to_string(robot.cables.size());
      cable.anchor = {7.0 * std::cos(at), 7.0 * std::sin(at), 5.5};
      const double from = at + (k % 2 == 0 ? crossed : -crossed);
      cable.attachment = {0.6 * std::cos(from), 0.6 * std::sin(from), ring % 2 == 0 ? 0.0 : 1.0};
      cable.properties = steelRope();
      cable.tension_min = 20.0;
      cable.tension_max = 5000.0;
      robot.cables.push_back(cable);
    }
  }
  return robot;
}

// A forward solve from 10 mm away [s].
double forwardTime(int cables, Model model, int rounds) {
  const RobotDescription robot = robotOfRings(cables / 4);
  InverseRequest request = requestFor(robot, robot.home);
  request.pose.position += Eigen::Vector3d(0.3, 0.2, 0.1);
  request.preferred_tensions.assign(robot.cables.size(), 450.0);
  const RobotSolution there = solveInverse(robot, request, patient(model));
  if (!there.report.status.ok()) throw std::runtime_error(there.report.status.message);
  ForwardRequest forward;
  forward.lengths = lengthsOf(there);
  forward.seed = there.pose;
  forward.seed->position.x() += 0.01;
  RobotSolution back;
  const double time = medianTime(rounds, [&] { back = solveForward(robot, forward, patient(model)); });
  if (!back.report.status.ok()) throw std::runtime_error(back.report.status.message);
  if (!samePose(back.pose, there.pose, 1e-6)) throw std::runtime_error("the forward solve led to another pose");
  return time;
}

void growWithCables(BenchmarkReport* report) {
  for (const Model model : {Model::kCatenary, Model::kBending}) {
    std::printf("forward, %s\n", modelName(model));
    double of_eight = 0.0;
    for (const int cables : {4, 8, 16, 32}) {
      const double time = forwardTime(cables, model, report->quick() ? 5 : 101);
      std::printf("%6d cables %10.1f us\n", cables, 1e6 * time);
      if (cables == 8) of_eight = time;
      if (cables == 32) {
        report->atMost(7, std::string("forward, ") + modelName(model) + ": 32 cables / 8 cables", time / of_eight, 6.0);
      }
    }
  }
}

// The same rope as CoGiRo's, with the bending stiffness that gives kappa L.
void growWithLayers(BenchmarkReport* report) {
  constexpr double kX = 8.0;
  constexpr double kY = -4.0;
  CableProperties cable = steelRope();
  CableSolverOptions options;
  const double tension = 500.0;
  options.model = Model::kCatenary;
  const double length = findLength(cable, kX, kY, tension, 0.0, options).length;
  options.model = Model::kBending;
  std::printf("one cable, its forces\n%10s %12s\n", "kappa L", "us");
  double least = 0.0;
  double most = 0.0;
  for (const double layers : {50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0}) {
    cable.bending_stiffness = tension * std::pow(length / layers, 2);
    CableSolution solution;
    const double time =
        medianTime(report->quick() ? 5 : 301, [&] { solution = findForces(cable, length, kX, kY, options); });
    if (!solution.status.ok()) throw std::runtime_error(solution.status.message);
    std::printf("%10.0f %12.1f\n", layers, 1e6 * time);
    least = least == 0.0 ? time : std::min(least, time);
    most = std::max(most, time);
  }
  report->atMost(7, "one cable: slowest / fastest of kappa L 50 to 5000", most / least, 1.5);
}

// Where layers fill the cable, so that integration is all there is.
void growWithAccuracy(BenchmarkReport* report) {
  const CableProperties cable = paperBar();
  constexpr double kLength = 5.65;
  CableSolverOptions options;
  options.tolerance = 1e-13;
  const CableSolution exact = findForces(cable, kLength, 5.0, -2.5, options);
  if (!exact.status.ok()) throw std::runtime_error(exact.status.message);
  std::printf("the paper's bar, its forces\n%10s %10s %12s %14s\n", "tolerance", "us", "error", "evaluations");
  constexpr double kRounding = 1e-12;  // smaller errors say nothing about the order
  // Slope of log(error) over log(evaluations per iteration), by least squares.
  double n = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  double sum_xx = 0.0;
  double sum_xy = 0.0;
  double first = 0.0;
  double last = 0.0;
  for (int i = 4; i <= 10; ++i) {
    options.tolerance = std::pow(10.0, -i);
    CableSolution solution;
    const double time =
        medianTime(report->quick() ? 5 : 301, [&] { solution = findForces(cable, kLength, 5.0, -2.5, options); });
    if (!solution.status.ok()) throw std::runtime_error(solution.status.message);
    const double error = std::hypot(solution.horizontal_force - exact.horizontal_force,
                                    solution.vertical_force_a - exact.vertical_force_a) /
                         exact.tension_a;
    std::printf("%10.0e %10.1f %12.1e %14d\n", options.tolerance, 1e6 * time, error, solution.evaluations);
    if (i == 4) first = time;
    last = time;
    if (error < kRounding) continue;
    const double x = std::log(static_cast<double>(solution.evaluations) / solution.iterations);
    const double y = std::log(error);
    n += 1.0;
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  report->figure(7, "the paper's bar: observed order, error over evaluations",
                 -(n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x), "");
  report->figure(7, "the paper's bar: time at tolerance 1e-10 / at 1e-4", last / first, "");
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  using namespace cdpr_kinetostatics;
  BenchmarkReport report(argc, argv);
  growWithCables(&report);
  growWithLayers(&report);
  growWithAccuracy(&report);
  return report.finish();
}

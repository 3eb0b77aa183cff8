// Analytic sensitivities of shots against automatic differentiation of the integrator and finite differences
// (docs/performance.md, item 4): shot by shot, and in the same forward solve of a robot.
//
// For the latter this program defines the functions of shot.h anew. Its definitions take the place of those in the
// package's library, so that the solve is the package's own but for the way its shots are differentiated.
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cable/shot.h"
#include "robot/coupled_newton.h"
#include "robot_cases.h"
#include "shots/derivative_shots.h"
#include "support/benchmark_report.h"
#include "support/converged_shots.h"
#include "timing/timing.h"

// The package's shots under names of their own.
#define shootAdaptive analyticShootAdaptive
#define shootOnGrid analyticShootOnGrid
#include "../src/cable/shot.cpp"
#undef shootAdaptive
#undef shootOnGrid

namespace cdpr_kinetostatics {
namespace {

struct ShotFunctions {
  const char* name;
  decltype(&analyticShootAdaptive) adaptive;
  decltype(&analyticShootOnGrid) on_grid;
};
constexpr ShotFunctions kAnalytic = {"analytic", analyticShootAdaptive, analyticShootOnGrid};
constexpr ShotFunctions kAutomatic = {"automatic", AutomaticShot::adaptive, AutomaticShot::onGrid};
constexpr ShotFunctions kDifferences = {"differences", DifferencesShot::adaptive, DifferencesShot::onGrid};
const std::vector<ShotFunctions> kAll = {kAnalytic, kAutomatic, kDifferences};

// Those that a solve of this program uses, and how often it has.
ShotFunctions in_use = kAnalytic;
long calls = 0;

}  // namespace

bool shootAdaptive(const ShotParameters& parameters, double t0, double t1, const ShotState& start, double tolerance,
                   StepGrid* grid, Shot* shot) {
  ++calls;
  return in_use.adaptive(parameters, t0, t1, start, tolerance, grid, shot);
}

bool shootOnGrid(const ShotParameters& parameters, double t0, const ShotState& start, const StepGrid& grid,
                 double scale, Shot* shot) {
  ++calls;
  return in_use.on_grid(parameters, t0, start, grid, scale, shot);
}

namespace {

constexpr double kTolerance = 1e-8;
constexpr double kShotTolerance = 1e-10;

// Medians of the times of jobs, which take turns.
std::vector<double> timesInTurn(const std::vector<std::function<void()>>& jobs, int rounds) {
  std::vector<std::vector<double>> times(jobs.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const double begin = now();
      jobs[i]();
      times[i].push_back(now() - begin);
    }
  }
  std::vector<double> medians;
  for (const std::vector<double>& of_one : times) medians.push_back(quantile(of_one, 0.5));
  return medians;
}

// The three must be the same integrator: equal steps, equal ends, equal derivatives but for the differences' error.
void requireSame(const ShotProblem& problem) {
  Shot shots[3];
  StepGrid grids[3];
  for (std::size_t i = 0; i < kAll.size(); ++i) {
    if (!kAll[i].adaptive(problem.parameters, problem.t0, problem.t1, problem.start, kShotTolerance, &grids[i],
                          &shots[i])) {
      throw std::runtime_error(std::string("a shot was rejected: ") + kAll[i].name);
    }
    const double end = std::max({std::abs(shots[i].end.alpha - shots[0].end.alpha),
                                 std::abs(shots[i].end.moment - shots[0].end.moment),
                                 std::abs(shots[i].end.x - shots[0].end.x), std::abs(shots[i].end.y - shots[0].end.y)});
    const double derivative = (shots[i].sensitivity - shots[0].sensitivity).lpNorm<Eigen::Infinity>() /
                              shots[0].sensitivity.lpNorm<Eigen::Infinity>();
    if (grids[i].size() != grids[0].size() || end > 1e-11 || derivative > (i == 2 ? 1e-5 : 1e-11)) {
      throw std::runtime_error(std::string("not the integrator of src/cable/shot.cpp: ") + kAll[i].name);
    }
  }
}

void compareShots(const std::string& name, int rounds, BenchmarkReport* report) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
  const std::vector<ShotProblem> problems = convergedShots(robot, robot.home, 15.0);
  for (const ShotProblem& problem : problems) requireSame(problem);
  std::vector<std::function<void()>> jobs;
  for (const ShotFunctions& functions : kAll) {
    jobs.emplace_back([&problems, functions, grids = std::vector<StepGrid>(problems.size()),
                       shots = std::vector<Shot>(problems.size())]() mutable {
      for (std::size_t i = 0; i < problems.size(); ++i) {
        const ShotProblem& p = problems[i];
        functions.adaptive(p.parameters, p.t0, p.t1, p.start, kShotTolerance, &grids[i], &shots[i]);
        functions.on_grid(p.parameters, p.t0, p.start, grids[i], 1.0, &shots[i]);
      }
      keep(shots);
    });
  }
  // The bare pass: what a shot costs without derivatives.
  jobs.emplace_back([&problems, grids = std::vector<StepGrid>(problems.size())]() mutable {
    const auto ignore = [](const PlainState<double>&) {};
    for (std::size_t i = 0; i < problems.size(); ++i) {
      const ShotProblem& p = problems[i];
      const PlainParameters<double> parameters{p.parameters.h, p.parameters.v, p.parameters.q, p.parameters.eps};
      const PlainState<double> start{p.start.alpha, p.start.moment, 0.0, 0.0};
      PlainState<double> end;
      shootPlainAdaptive(parameters, p.t0, p.t1, start, kShotTolerance, &grids[i], &end, ignore);
      shootPlainOnGrid(parameters, p.t0, start, grids[i], 1.0, &end, ignore);
      keep(end);
    }
  });
  const std::vector<double> t = timesInTurn(jobs, rounds);
  report->figure(4, name + ": one shot, analytic", 1e6 * t[0] / (2.0 * static_cast<double>(problems.size())), "us");
  report->figure(4, name + ": one shot, analytic / bare pass without sensitivities", t[0] / t[3], "");
  report->figure(4, name + ": one shot, automatic / analytic", t[1] / t[0], "");
  report->figure(4, name + ": one shot, differences / analytic", t[2] / t[0], "");
}

// A path of steps of 10 mm, and the robot's lengths along it.
struct Path {
  RobotDescription robot;
  std::vector<std::vector<double>> lengths;
  CoupledState start;
};

Path pathOf(const std::string& name, int steps) {
  Path path;
  path.robot = shippedRobot(ROBOT_DIR, name);
  for (int i = 0; i <= steps; ++i) {
    Pose pose = path.robot.home;
    pose.position.x() += 0.01 * i;
    const RobotSolution there = solveInverse(path.robot, requestFor(path.robot, pose), patient(Model::kBending));
    if (!there.report.status.ok()) throw std::runtime_error(there.report.status.message);
    path.lengths.push_back(lengthsOf(there));
    if (i > 0) continue;
    path.start.pose = there.pose;
    for (std::size_t k = 0; k < there.cables.size(); ++k) {
      const CableSolution& known = there.cables[k].cable;
      path.start.cables.emplace_back(path.robot.cables[k].properties, Model::kBending, kTolerance);
      const SolveLimits options{kTolerance};
      if (!path.start.cables.back().startBetween(known.length, known.x, known.y, options).ok()) {
        throw std::runtime_error("a cable of " + name + " could not be started");
      }
    }
  }
  return path;
}

struct Walk {
  int iterations = 0;
  std::vector<Pose> poses;
};

// Each pose from the one before, by Newton's method on the robot and its cables' shots together.
Walk walk(const Path& path) {
  Walk result;
  CoupledState state = path.start;
  CoupledNewton newton(path.robot);
  for (const std::vector<double>& lengths : path.lengths) {
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      SaggingCable& cable = state.cables[k];
      cable.step({0.0, 0.0, lengths[k] - cable.length()}, 1.0);
    }
    const SearchOutcome outcome = solveCoupled(Wrench::Zero(), {kTolerance}, &newton, &state);
    if (!outcome.status.ok()) throw std::runtime_error(outcome.status.message);
    result.iterations += outcome.iterations;
    result.poses.push_back(state.pose);
  }
  return result;
}

void compareSolves(const std::string& name, int steps, int rounds, BenchmarkReport* report) {
  in_use = kAnalytic;
  const Path path = pathOf(name, steps);
  Walk walks[3];
  std::vector<std::function<void()>> jobs;
  for (std::size_t i = 0; i < kAll.size(); ++i) {
    jobs.emplace_back([&, i] {
      in_use = kAll[i];
      walks[i] = walk(path);
    });
  }
  calls = 0;
  const std::vector<double> t = timesInTurn(jobs, rounds);
  if (calls == 0) throw std::runtime_error("the library did not call this program's shots");
  for (std::size_t i = 0; i < kAll.size(); ++i) {
    for (std::size_t k = 0; k < path.lengths.size(); ++k) {
      if (!samePose(walks[i].poses[k], walks[0].poses[k], 1e-7)) {
        throw std::runtime_error(std::string("another pose by ") + kAll[i].name);
      }
    }
    std::printf("%s: %.1f iterations per solve by %s shots\n", name.c_str(),
                static_cast<double>(walks[i].iterations) / static_cast<double>(path.lengths.size()), kAll[i].name);
  }
  report->figure(4, name + ": forward solve from 10 mm away, analytic",
                 1e6 * t[0] / static_cast<double>(path.lengths.size()), "us");
  report->atLeast(4, name + ": forward solve, automatic / analytic", t[1] / t[0], 2.0);
  report->atLeast(4, name + ": forward solve, differences / analytic", t[2] / t[0], 4.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  using namespace cdpr_kinetostatics;
  BenchmarkReport report(argc, argv);
  const int rounds = report.quick() ? 5 : 51;
  for (const char* robot : {"cogiro", "desktop_music_wire"}) {
    compareShots(robot, rounds, &report);
    compareSolves(robot, report.quick() ? 3 : 10, rounds, &report);
  }
  return report.finish();
}

// Shots with their sensitivities by this package's integrator and by SUNDIALS' CVODES, at equal error
// (docs/performance.md, item 5).
//
// CVODES is given every choice of method, corrector, treatment of sensitivities and tolerance; what it is compared by
// is the fastest choice whose error is no larger than ours.
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "robot_cases.h"
#include "sundials/cvodes_shot.h"
#include "support/benchmark_report.h"
#include "support/converged_shots.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

// Largest error over the shots: of the states at their ends, and of the sensitivities relative to the largest of each.
struct Run {
  double time = 0.0;  // [s] per shot
  double state_error = 0.0;
  double sensitivity_error = 0.0;
};

struct Candidate {
  CvodesSettings settings;
  double tolerance = 0.0;
  double evaluations = 0.0;  // of the right-hand side, per shot
  Run run;
};

Eigen::Vector4d vectorOf(const ShotState& state) { return {state.alpha, state.moment, state.x, state.y}; }

// shoot(problem, shot): false where the shot is rejected.
template <typename Shoot>
bool measure(const std::vector<ShotProblem>& problems, const std::vector<Shot>& exact, int rounds, const Shoot& shoot,
             Run* run) {
  Shot shot;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    if (!shoot(problems[i], &shot)) return false;
    run->state_error =
        std::max(run->state_error, (vectorOf(shot.end) - vectorOf(exact[i].end)).lpNorm<Eigen::Infinity>());
    run->sensitivity_error =
        std::max(run->sensitivity_error, (shot.sensitivity - exact[i].sensitivity).lpNorm<Eigen::Infinity>() /
                                             exact[i].sensitivity.lpNorm<Eigen::Infinity>());
  }
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    const double begin = now();
    for (const ShotProblem& problem : problems) {
      shoot(problem, &shot);
      keep(shot);
    }
    times.push_back((now() - begin) / static_cast<double>(problems.size()));
  }
  run->time = quantile(times, 0.5);
  return true;
}

bool measureCvodes(const std::vector<ShotProblem>& problems, const std::vector<Shot>& exact, int rounds,
                   Candidate* candidate) {
  CvodesShot cvodes(candidate->settings);
  const auto shoot = [&](const ShotProblem& p, Shot* shot) {
    return cvodes.shoot(p.parameters, p.t0, p.t1, p.start, candidate->tolerance, shot);
  };
  candidate->run = Run();
  if (!measure(problems, exact, rounds, shoot, &candidate->run)) return false;
  candidate->evaluations = static_cast<double>(cvodes.evaluations()) / (1.0 + rounds) / problems.size();
  return true;
}

std::vector<Candidate> runCvodes(const std::vector<ShotProblem>& problems, const std::vector<Shot>& exact,
                                 int per_decade) {
  std::vector<Candidate> candidates;
  for (int choice = 0; choice < 16; ++choice) {
    const CvodesSettings settings{(choice & 1) != 0, (choice & 2) != 0, (choice & 4) != 0, (choice & 8) != 0};
    for (int i = 2 * per_decade; i <= 13 * per_decade; ++i) {
      Candidate candidate{settings, std::pow(10.0, -static_cast<double>(i) / per_decade), 0.0, {}};
      if (measureCvodes(problems, exact, 2, &candidate)) candidates.push_back(candidate);
    }
  }
  return candidates;
}

// The fastest with errors no larger than ours; of the sensitivities too, if asked for.
Candidate fastest(const std::vector<Candidate>& candidates, const Run& ours, bool sensitivities_too) {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : candidates) {
    if (candidate.run.state_error > ours.state_error) continue;
    if (sensitivities_too && candidate.run.sensitivity_error > ours.sensitivity_error) continue;
    if (best == nullptr || candidate.run.time < best->run.time) best = &candidate;
  }
  if (best == nullptr) throw std::runtime_error("CVODES does not reach this accuracy");
  return *best;
}

void compare(const std::string& name, BenchmarkReport* report) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
  const std::vector<ShotProblem> problems = convergedShots(robot, robot.home, 15.0);
  StepGrid grid;
  const auto ours = [&](double tolerance) {
    return [&grid, tolerance](const ShotProblem& p, Shot* shot) {
      grid.clear();
      return shootAdaptive(p.parameters, p.t0, p.t1, p.start, tolerance, &grid, shot);
    };
  };
  std::vector<Shot> exact(problems.size());
  for (std::size_t i = 0; i < problems.size(); ++i) {
    if (!ours(1e-14)(problems[i], &exact[i])) throw std::runtime_error("a shot was rejected");
  }
  const int rounds = report->quick() ? 3 : 21;
  const std::vector<Candidate> candidates = runCvodes(problems, exact, report->quick() ? 1 : 3);
  std::printf("%s, %zu shots: time, evaluations, largest errors of states and sensitivities\n", name.c_str(),
              problems.size());
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    Run run;
    if (!measure(problems, exact, 10 * rounds, ours(tolerance), &run)) throw std::runtime_error("a shot was rejected");
    double evaluations = 0.0;
    for (const ShotProblem& problem : problems) {
      Shot shot;
      ours(tolerance)(problem, &shot);
      evaluations += 6.0 * static_cast<double>(grid.size()) + 1.0;
    }
    std::printf("  ours, %.0e per step: %.2f us, %.0f, %.1e, %.1e\n", tolerance, 1e6 * run.time,
                evaluations / static_cast<double>(problems.size()), run.state_error, run.sensitivity_error);
    double ratio[2];
    for (const bool sensitivities_too : {false, true}) {
      Candidate best = fastest(candidates, run, sensitivities_too);
      measureCvodes(problems, exact, rounds, &best);
      const CvodesSettings& s = best.settings;
      std::printf("    CVODES (%s, %s, %s%s, %.1e): %.2f us, %.0f, %.1e, %.1e\n", s.bdf ? "BDF" : "Adams",
                  s.newton ? "Newton" : "fixed point", s.staggered ? "staggered" : "simultaneous",
                  s.error_control ? ", error control" : "", best.tolerance, 1e6 * best.run.time, best.evaluations,
                  best.run.state_error, best.run.sensitivity_error);
      ratio[sensitivities_too ? 1 : 0] = best.run.time / run.time;
    }
    if (tolerance == 1e-10) {  // what one step may err by in a solve to 1e-8
      report->atLeast(5, name + ": shot, CVODES / ours, states equally exact", ratio[0], 3.0);
      report->figure(5, name + ": shot, CVODES / ours, sensitivities equally exact, too", ratio[1], "");
    }
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  using namespace cdpr_kinetostatics;
  BenchmarkReport report(argc, argv);
  for (const char* robot : {"cogiro", "desktop_music_wire"}) compare(robot, &report);
  return report.finish();
}

#include "tradeoff/measurement.h"

#include <algorithm>
#include <cmath>

#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

// An error that could not be found out in one trial is not known for the row.
void raiseOrForget(const std::optional<double>& value, bool first, std::optional<double>* largest) {
  if (first || !value) {
    *largest = value;
  } else if (*largest) {
    *largest = std::max(**largest, *value);
  }
}

std::vector<Trial*> judge(const std::vector<std::unique_ptr<Trial>>& trials, Row* row) {
  std::vector<Trial*> solved;
  std::vector<double> iterations, steps, evaluations;
  for (const std::unique_ptr<Trial>& trial : trials) {
    trial->prepare();
    trial->solve();
    const Outcome outcome = trial->outcome();
    if (!outcome.status.ok()) {
      if (row->refusal.empty()) row->refusal = outcome.status.message;
      continue;
    }
    const bool first = solved.empty();
    raiseOrForget(outcome.errors.position, first, &row->errors.position);
    raiseOrForget(outcome.errors.rotation, first, &row->errors.rotation);
    raiseOrForget(outcome.errors.tension, first, &row->errors.tension);
    raiseOrForget(outcome.estimated_error, first, &row->estimated_error);
    row->finest = std::max(row->finest, outcome.finest);
    iterations.push_back(outcome.iterations);
    steps.push_back(outcome.integrator_steps);
    evaluations.push_back(outcome.evaluations);
    solved.push_back(trial.get());
  }
  row->trials = static_cast<int>(trials.size());
  row->solved = static_cast<int>(solved.size());
  row->iterations = quantile(iterations, 0.5);
  row->integrator_steps = quantile(steps, 0.5);
  row->evaluations = quantile(evaluations, 0.5);
  return solved;
}

void timeAll(const std::vector<Trial*>& trials, const Effort& effort, Row* row) {
  std::vector<double> times;
  const double begin = now();
  do {
    for (Trial* trial : trials) {
      trial->prepare();
      const double start = now();
      trial->solve();
      times.push_back(now() - start);
    }
  } while (now() - begin < effort.seconds_per_row && static_cast<int>(times.size()) < effort.samples_per_row);
  row->median_time = quantile(times, 0.5);
  row->p99_time = quantile(times, 0.99);
}

// False if the solvers do not serve this model.
bool isServed(Model model, const RobotDescription& robot, const Scenario& scenario) {
  const auto trial = makeRobotTrial(Problem::kInverse, robot, scenario, {model, 1e-6, 1e-3});
  trial->solve();
  return trial->outcome().status.code != Code::kInvalidInput;
}

}  // namespace

Effort Effort::full() { return {{1e-3, 1e-5, 1e-7, 1e-9, 1e-11}, {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, 5, 0.1, 300}; }
Effort Effort::quick() { return {{1e-3, 1e-6, 1e-9}, {1e-4, 1e-6}, 2, 0.005, 50}; }

RobotTrade measureTrade(const RobotDescription& robot, const Effort& effort) {
  const std::vector<Scenario> scenarios = scenariosFor(robot, effort.poses);
  RobotTrade trade;
  trade.robot = robot;
  trade.poses = static_cast<int>(scenarios.size());
  for (const Scenario& scenario : scenarios) {
    for (std::size_t i = 0; i < robot.cables.size(); ++i) {
      const CableSolution& cable = scenario.reference.cables[i].cable;
      const double bending_stiffness = robot.cables[i].properties.bending_stiffness;
      if (!(bending_stiffness > 0.0)) continue;
      const double layers = cable.length * std::sqrt(cable.tension_a / bending_stiffness);
      const auto [least, most] = trade.layers.value_or(std::make_pair(layers, layers));
      trade.layers = std::make_pair(std::min(least, layers), std::max(most, layers));
    }
  }

  std::vector<Setting> settings;
  for (const Model model : kRungs) {
    if (!isServed(model, robot, scenarios.front())) continue;
    for (const double tolerance : effort.tolerances) settings.push_back({model, tolerance, std::nullopt});
  }
  if (isServed(Model::kAuto, robot, scenarios.front())) {
    for (const double accuracy : effort.accuracies) settings.push_back({Model::kAuto, Setting().tolerance, accuracy});
  }
  for (const Setting& setting : settings) {
    for (const Problem problem : kProblems) {
      Row row;
      row.setting = setting;
      row.problem = problem;
      const auto trials = trialsOf(problem, robot, scenarios, setting);
      const std::vector<Trial*> solved = judge(trials, &row);
      if (!solved.empty()) timeAll(solved, effort, &row);
      trade.rows.push_back(row);
    }
  }
  return trade;
}

}  // namespace cdpr_kinetostatics

// Forward, inverse and estimate.
#include <algorithm>
#include <cmath>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "tradeoff/trial.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTimeout = 2.0;  // [s]

RobotSolverOptions solverOptions(const Setting& setting) {
  RobotSolverOptions options;
  options.model = setting.model;
  options.tolerance = setting.tolerance;
  options.timeout = std::chrono::duration<double>(kTimeout);
  if (setting.accuracy) options.accuracy = *setting.accuracy;
  return options;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

Errors errorsBetween(const RobotSolution& found, const RobotSolution& reference) {
  return {(found.pose.position - reference.pose.position).norm(),
          found.pose.orientation.angularDistance(reference.pose.orientation),
          largestDifference(tensionsOf(found), tensionsOf(reference))};
}

Outcome outcomeOf(const RobotReport& report) {
  Outcome outcome;
  outcome.status = report.status;
  outcome.finest = report.model;
  if (report.error_known) outcome.estimated_error = report.estimated_error;
  outcome.iterations = report.iterations;
  outcome.integrator_steps = report.integrator_steps;
  outcome.evaluations = report.evaluations;
  return outcome;
}

class ForwardTrial : public Trial {
 public:
  ForwardTrial(const RobotDescription& robot, const Scenario& scenario, const Setting& setting, bool warm)
      : robot_(robot), scenario_(scenario), options_(solverOptions(setting)) {
    request_.lengths = lengthsOf(scenario.reference);
    if (warm) request_.seed = scenario.previous.pose;
  }

  void solve() override { solution_ = solveForward(robot_, request_, options_); }

  Outcome outcome() const override {
    Outcome outcome = outcomeOf(solution_.report);
    if (outcome.status.ok()) outcome.errors = errorsBetween(solution_, scenario_.reference);
    return outcome;
  }

 private:
  const RobotDescription& robot_;
  const Scenario& scenario_;
  const RobotSolverOptions options_;
  ForwardRequest request_;
  RobotSolution solution_;
};

class InverseTrial : public Trial {
 public:
  InverseTrial(const RobotDescription& robot, const Scenario& scenario, const Setting& setting)
      : robot_(robot), scenario_(scenario), options_(solverOptions(setting)) {}

  void solve() override { solution_ = solveInverse(robot_, scenario_.request, options_); }

  Outcome outcome() const override {
    Outcome outcome = outcomeOf(solution_.report);
    if (!outcome.status.ok()) return outcome;
    ForwardRequest applied;
    applied.lengths = lengthsOf(solution_);
    applied.seed = solution_.pose;
    const RobotSolution there = solveForward(robot_, applied, referenceOptions());
    if (there.report.status.ok()) outcome.errors = errorsBetween(there, solution_);
    return outcome;
  }

 private:
  const RobotDescription& robot_;
  const Scenario& scenario_;
  const RobotSolverOptions options_;
  RobotSolution solution_;
};

class EstimateTrial : public Trial {
 public:
  EstimateTrial(const RobotDescription& robot, const Scenario& scenario, const Setting& setting)
      : scenario_(scenario),
        previous_(measure(scenario.previous)),
        measured_(measure(scenario.reference)),
        estimator_(robot, options(robot, setting)) {}

  void prepare() override {
    estimator_.setPose(scenario_.previous.pose);
    estimator_.update(previous_);
  }
  void solve() override { estimate_ = estimator_.update(measured_); }

  Outcome outcome() const override {
    Outcome outcome = outcomeOf(estimate_.solution.report);
    if (outcome.status.ok()) outcome.errors = errorsBetween(estimate_.solution, scenario_.reference);
    return outcome;
  }

 private:
  static EstimatorOptions options(const RobotDescription& robot, const Setting& setting) {
    EstimatorOptions options;
    options.model = setting.model;
    if (setting.accuracy) options.accuracy = *setting.accuracy;
    options.tolerance = setting.tolerance;
    options.timeout = std::chrono::duration<double>(kTimeout);
    options.load_stddev = EstimatorOptions::defaultLoadStddev(robot);
    return options;
  }
  static CableMeasurements measure(const RobotSolution& solution) {
    CableMeasurements measurements;
    for (const double length : lengthsOf(solution)) measurements.lengths.emplace_back(length);
    for (const double tension : tensionsOf(solution)) measurements.tensions.emplace_back(tension);
    return measurements;
  }

  const Scenario& scenario_;
  const CableMeasurements previous_, measured_;
  PoseEstimator estimator_;
  Estimate estimate_;
};

}  // namespace

std::unique_ptr<Trial> makeRobotTrial(Problem problem, const RobotDescription& robot, const Scenario& scenario,
                                      const Setting& setting) {
  if (problem == Problem::kInverse) return std::make_unique<InverseTrial>(robot, scenario, setting);
  if (problem == Problem::kEstimate) return std::make_unique<EstimateTrial>(robot, scenario, setting);
  return std::make_unique<ForwardTrial>(robot, scenario, setting, problem == Problem::kForwardWarm);
}

}  // namespace cdpr_kinetostatics

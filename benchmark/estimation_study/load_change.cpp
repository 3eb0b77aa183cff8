#include <cmath>
#include <cstdio>
#include <vector>

#include "estimation_study/study.h"
#include "support/csv_file.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kPayload = 0.2;  // of the platform's weight

// Root mean squares of errors and of the standard deviations that were predicted for them.
struct Errors {
  double load = 0.0, load_sigma = 0.0, pose = 0.0, pose_sigma = 0.0;
  int samples = 0;

  void add(double load_error, double of_load, double pose_error, double of_pose) {
    load += load_error * load_error;
    load_sigma += of_load * of_load;
    pose += pose_error * pose_error;
    pose_sigma += of_pose * of_pose;
    ++samples;
  }
  double rms(double sum) const { return samples == 0 ? 0.0 : std::sqrt(sum / samples); }
};

}  // namespace

void studyLoadChange(const Study& study) {
  CsvFile csv(study.directory + "/load_change.csv",
              "robot,given,step,payload,load,load_sigma,flagged,position_error,position_sigma");
  std::printf(
      "\n| robot | given | payload | error of the load: rms | predicted | first message | flagged as known load "
      "| position error: rms | predicted |\n|---|---|---|---|---|---|---|---|---|\n");
  const int steps = study.quick ? 60 : 300;
  for (const std::string& name : robots()) {
    for (const Given what : {Given::kAll, Given::kLoadUnknown}) {
      SimulatedRobot robot = simulated(study, name);
      configure(what, &robot.estimator);
      PoseEstimator estimator(robot.robot, robot.estimator);
      const double payload = -kPayload * robot.robot.weight();
      Errors errors;
      double first_error = 0.0;
      int flagged = 0, open = 0;
      const std::vector<RobotSolution> states = circle(robot, steps);
      for (int step = 0; step < steps; ++step) {
        const bool loaded = step >= steps / 3 && step < 2 * steps / 3;
        robot.truth = states[step];
        Wrench load = Wrench::Zero();
        load(2) = loaded ? payload : 0.0;
        const RobotSolution truth = robot.under(load);
        const Estimate estimate = estimator.update(robot.measure(truth, 1.0));
        if (!truth.report.status.ok() || !estimate.solution.report.status.ok()) {
          std::fprintf(stderr, "%s, %s, step %d: %s%s\n", name.c_str(), nameOf(what).c_str(), step,
                       truth.report.status.message.c_str(), estimate.solution.report.status.message.c_str());
          continue;
        }
        const double position_error = (estimate.solution.pose.position - truth.pose.position).norm();
        const double position_sigma = std::sqrt(estimate.covariance.diagonal().head<3>().sum());
        csv.row(name, nameOf(what), step, load(2), estimate.load(2), sigma(estimate.load_covariance, 2),
                estimate.load_outlier(2), position_error, position_sigma);
        if (!loaded) continue;
        if (step == steps / 3) first_error = estimate.load(2) - payload;
        open += static_cast<int>(estimate.unobservable_directions > 0 || estimate.load_unknown(2));
        flagged += static_cast<int>(estimate.load_outlier(2));
        errors.add(estimate.load(2) - payload, sigma(estimate.load_covariance, 2), position_error, position_sigma);
      }
      if (open > 0) {
        std::printf("| `%s` | %s | %.4g N | directions are open | | | | | |\n", name.c_str(), nameOf(what).c_str(),
                    -payload);
        continue;
      }
      std::printf("| `%s` | %s | %.4g N | %.3g N | %.3g N | %.3g N | %.0f %% | %.3g mm | %.3g mm |\n", name.c_str(),
                  nameOf(what).c_str(), -payload, errors.rms(errors.load), errors.rms(errors.load_sigma), first_error,
                  100.0 * flagged / errors.samples, 1e3 * errors.rms(errors.pose), 1e3 * errors.rms(errors.pose_sigma));
    }
  }
}

}  // namespace cdpr_kinetostatics

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "estimation_study/study.h"
#include "support/csv_file.h"

namespace cdpr_kinetostatics {
namespace {

double normalised(const Wrench& error, const Eigen::Matrix<double, 6, 6>& covariance, int n) {
  return error.head(n).dot(covariance.topLeftCorner(n, n).ldlt().solve(error.head(n)));
}

// Upper 5 % point of the chi-square distribution.
double chiSquare95(int freedoms) { return freedoms == 3 ? 7.814728 : 12.591587; }

struct Sums {
  int samples = 0, beyond = 0, flagged = 0, open = 0, failed = 0;
  double pose = 0.0, load = 0.0;
};

Sums sample(const Study& study, const std::string& name, Given what, CsvFile* csv) {
  SimulatedRobot robot = simulated(study, name);
  configure(what, &robot.estimator);
  const int n = robot.robot.freedoms();
  const int poses = study.quick ? 4 : 20;
  const int per_pose = study.quick ? 50 : 100;
  Sums sums;
  for (int p = 0; p < poses; ++p) {
    moveToRandomPose(&robot);
    PoseEstimator estimator(robot.robot, robot.estimator);
    estimator.setPose(robot.truth.pose);
    for (int k = 0; k < per_pose; ++k) {
      const Wrench load = robot.randomLoad();
      const RobotSolution truth = robot.under(load);
      const Estimate estimate = estimator.update(given(what, robot.measure(truth, 1.0)));
      if (!truth.report.status.ok() || !estimate.solution.report.status.ok()) {
        ++sums.failed;
        continue;
      }
      if (estimate.unobservable_directions > 0) {
        ++sums.open;
        continue;
      }
      const double pose = normalised(poseError(estimate.solution.pose, truth.pose), estimate.covariance, n);
      const double of_load = normalised(estimate.load - load, estimate.load_covariance, n);
      ++sums.samples;
      sums.pose += pose;
      sums.load += of_load;
      sums.beyond += static_cast<int>(pose > chiSquare95(n));
      const auto any = [](const std::vector<bool>& flags) {
        return std::any_of(flags.begin(), flags.end(), [](bool flag) { return flag; });
      };
      sums.flagged += static_cast<int>(any(estimate.length_outlier) || any(estimate.tension_outlier) ||
                                       estimate.load_outlier.any());
      csv->row(name, nameOf(what), n, p, pose, of_load);
    }
  }
  return sums;
}

}  // namespace

void studyConsistency(const Study& study) {
  CsvFile csv(study.directory + "/consistency.csv", "robot,given,freedoms,pose,pose_nees,load_nees");
  std::printf(
      "\n| robot | given | samples | mean error^2 / freedoms: pose | load | beyond 95 %% point | false alarms |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  for (const std::string& name : robots()) {
    for (const Given what : kEveryGiven) {
      const Sums s = sample(study, name, what, &csv);
      const int n = simulated(study, name).robot.freedoms();
      if (s.samples == 0) {
        std::printf("| `%s` | %s | 0 | directions are open | | | |\n", name.c_str(), nameOf(what).c_str());
        continue;
      }
      std::printf("| `%s` | %s | %d | %.3f | %.3f | %.1f %% | %d |\n", name.c_str(), nameOf(what).c_str(), s.samples,
                  s.pose / s.samples / n, s.load / s.samples / n, 100.0 * s.beyond / s.samples, s.flagged);
      if (s.failed + s.open > 0) {
        std::fprintf(stderr, "%s, %s: %d failed, %d with open directions\n", name.c_str(), nameOf(what).c_str(),
                     s.failed, s.open);
      }
    }
  }
}

}  // namespace cdpr_kinetostatics

#include <cmath>
#include <cstdio>
#include <string>

#include "estimation_study/study.h"
#include "support/csv_file.h"

namespace cdpr_kinetostatics {
namespace {

// Largest standard deviation of three components.
std::string largest(const Eigen::Matrix<double, 6, 6>& covariance, int first, double unit, const char* name) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g %s", std::sqrt(covariance.diagonal().segment<3>(first).maxCoeff()) / unit,
                name);
  return text;
}

}  // namespace

void studyObservability(const Study& study) {
  CsvFile csv(study.directory + "/observability.csv",
              "robot,given,redundancy,open_directions,open_load,position_sigma,rotation_sigma,force_sigma");
  std::printf(
      "\n| robot | measured | redundancy | open directions of the pose | open components of the load "
      "| largest sigma: position | rotation | force |\n|---|---|---|---|---|---|---|---|\n");
  for (const std::string& name : robots()) {
    for (const Given what : kEveryGiven) {
      for (const bool first_silent : {false, true}) {
        SimulatedRobot robot = simulated(study, name);
        configure(what, &robot.estimator);
        CableMeasurements measurements = given(what, robot.measure(robot.truth, 0.0));
        if (first_silent) {
          measurements.lengths[0].reset();
          measurements.tensions[0].reset();
        }
        PoseEstimator estimator(robot.robot, robot.estimator);
        estimator.setPose(robot.truth.pose);
        const Estimate estimate = estimator.update(measurements);
        const std::string label = nameOf(what) + (first_silent ? ", first cable silent" : "");
        if (!estimate.solution.report.status.ok()) {
          std::printf("| `%s` | %s | %s |\n", name.c_str(), label.c_str(),
                      estimate.solution.report.status.message.c_str());
          continue;
        }
        const int n = robot.robot.freedoms();
        const auto open_load = estimate.load_unknown.count();
        const bool open = estimate.unobservable_directions > 0;
        const std::string position = open ? "" : largest(estimate.covariance, 0, 1e-3, "mm");
        const std::string rotation = open || n == 3 ? "" : largest(estimate.covariance, 3, 1e-3, "mrad");
        const std::string force = open_load > 0 ? "" : largest(estimate.load_covariance, 0, 1.0, "N");
        std::printf("| `%s` | %s | %d | %d | %d | %s | %s | %s |\n", name.c_str(), label.c_str(), estimate.redundancy,
                    estimate.unobservable_directions, static_cast<int>(open_load), position.c_str(), rotation.c_str(),
                    force.c_str());
        csv.row(name, label, estimate.redundancy, estimate.unobservable_directions, open_load, position, rotation,
                force);
      }
    }
  }
}

}  // namespace cdpr_kinetostatics

#include <cstdio>

#include "estimation_study/study.h"
#include "support/csv_file.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

struct Times {
  std::vector<double> tracking, faulty, onset, cold;  // [s]
};

// Rounds on a circle: clean, and with a cell that is 30 % off from the second message on.
Times measureTimes(const Study& study, SimulatedRobot* robot) {
  Times times;
  const std::vector<RobotSolution> states = circle(*robot, 50);
  std::size_t tautest = 0;
  const std::vector<double> tensions = tensionsOf(states.front());
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    if (tensions[i] > tensions[tautest]) tautest = i;
  }
  for (int round = 0; round < (study.quick ? 2 : 10); ++round) {
    PoseEstimator clean(robot->robot, robot->estimator);
    PoseEstimator disturbed(robot->robot, robot->estimator);
    for (std::size_t k = 0; k < states.size(); ++k) {
      CableMeasurements measurements = robot->measure(states[k], 1.0);
      const auto timed = [&](PoseEstimator* estimator) {
        return estimator->update(measurements).solution.report.solve_time;
      };
      (k == 0 ? times.cold : times.tracking).push_back(timed(&clean));
      if (k > 0) *measurements.tensions[tautest] *= 1.3;
      const double disturbed_time = timed(&disturbed);
      if (k == 1) times.onset.push_back(disturbed_time);
      if (k > 1) times.faulty.push_back(disturbed_time);
    }
  }
  return times;
}

}  // namespace

void studyTiming(const Study& study) {
  CsvFile csv(study.directory + "/timing.csv", "robot,model,case,median,p99");
  std::printf(
      "\n| robot | model | tracking: median | 99 %% | with a faulty cell: median | 99 %% | when it comes "
      "| first message |\n|---|---|---|---|---|---|---|---|\n");
  for (const std::string& name : robots()) {
    for (const Model model : {Model::kCatenary, Model::kBending}) {
      SimulatedRobot robot = simulatedRobot(ROBOT_DIR, name, model);
      const Times times = measureTimes(study, &robot);
      const auto ms = [](const std::vector<double>& values, double share) { return 1e3 * quantile(values, share); };
      std::printf("| `%s` | %s | %.2f ms | %.2f ms | %.2f ms | %.2f ms | %.2f ms | %.2f ms |\n", name.c_str(),
                  modelName(model), ms(times.tracking, 0.5), ms(times.tracking, 0.99), ms(times.faulty, 0.5),
                  ms(times.faulty, 0.99), ms(times.onset, 0.5), ms(times.cold, 0.5));
      const auto write = [&](const char* which, const std::vector<double>& values) {
        csv.row(name, modelName(model), which, quantile(values, 0.5), quantile(values, 0.99));
      };
      write("tracking", times.tracking);
      write("faulty", times.faulty);
      write("onset", times.onset);
      write("cold", times.cold);
    }
  }
}

}  // namespace cdpr_kinetostatics

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "estimation_study/study.h"
#include "hostile_messages.h"
#include "support/csv_file.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kGood = 10;          // messages
constexpr double kSame = 1e-6;     // of the poses [m], [rad]
constexpr double kTimeout = 0.05;  // [s] hostile messages may use it up

}  // namespace

void studyRecovery(const Study& study) {
  CsvFile csv(study.directory + "/recovery.csv", "robot,sequence,solved,difference");
  std::printf(
      "\n| robot | sequences of hostile messages | another answer after ten good ones | largest difference "
      "| no answer in time |\n");
  std::printf("|---|---|---|---|---|\n");
  for (const std::string& name : robots()) {
    SimulatedRobot robot = simulated(study, name);
    robot.estimator.timeout = std::chrono::duration<double>(kTimeout);
    const Workspace workspace = workspaceOf(name);
    Dice dice(29);
    PoseEstimator estimator(robot.robot, robot.estimator);  // one for all: each sequence inherits the ones before
    int wrong = 0, late = 0;
    double largest = 0.0;
    const int sequences = study.quick ? 100 : 2000;
    for (int sequence = 0; sequence < sequences;) {
      if (!robot.moveTo(randomPose(workspace, &robot.dice))) continue;
      ++sequence;
      const CableMeasurements good = robot.measure(robot.truth, 0.0);
      mistreat(robot, good, &dice, &estimator);
      Estimate last;
      for (int k = 0; k < kGood; ++k) last = estimator.update(good);
      const Estimate fresh = PoseEstimator(robot.robot, robot.estimator).update(good);
      const bool solved = last.solution.report.status.ok() && fresh.solution.report.status.ok();
      const double difference = poseError(last.solution.pose, fresh.solution.pose).head(robot.robot.freedoms()).norm();
      wrong += static_cast<int>(solved && difference > kSame);
      late += static_cast<int>(!solved);
      if (solved) largest = std::max(largest, difference);
      csv.row(name, sequence, solved, difference);
    }
    std::printf("| `%s` | %d | %d | %.1e | %d |\n", name.c_str(), sequences, wrong, largest, late);
    std::fflush(stdout);
  }
}

}  // namespace cdpr_kinetostatics

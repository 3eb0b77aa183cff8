#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "estimation_study/study.h"
#include "robot/platform_statics.h"
#include "support/csv_file.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

enum class Fault { kStuckCell, kHighCell, kLowCell, kDeadCell, kTurnMore, kTurnLess };
constexpr Fault kFaults[] = {Fault::kStuckCell, Fault::kHighCell, Fault::kLowCell,
                             Fault::kDeadCell,  Fault::kTurnMore, Fault::kTurnLess};

constexpr int kSteps = 20;     // from the last good measurement to the one that is judged
constexpr double kFar = 0.05;  // the platform moves so much of the span meanwhile

// Drum's circumference over the robot's span: half a metre for CoGiRo.
constexpr double kTurn = 0.03;

const char* nameOf(Fault fault) {
  switch (fault) {
    case Fault::kStuckCell:
      return "cell stuck";
    case Fault::kHighCell:
      return "cell +30 %";
    case Fault::kLowCell:
      return "cell -30 %";
    case Fault::kDeadCell:
      return "cell reads 0";
    case Fault::kTurnMore:
      return "drum turn too long";
    case Fault::kTurnLess:
      return "drum turn too short";
  }
  return "";
}

bool ofLength(Fault fault) { return fault == Fault::kTurnMore || fault == Fault::kTurnLess; }

// At a measurement, with what was read before the fault came.
CableMeasurements withFault(Fault fault, std::size_t cable, double turn, const CableMeasurements& before,
                            CableMeasurements measurements) {
  double& tension = *measurements.tensions[cable];
  switch (fault) {
    case Fault::kStuckCell:
      tension = *before.tensions[cable];
      break;
    case Fault::kHighCell:
      tension *= 1.3;
      break;
    case Fault::kLowCell:
      tension *= 0.7;
      break;
    case Fault::kDeadCell:
      tension = 0.0;
      break;
    case Fault::kTurnMore:
      *measurements.lengths[cable] += turn;
      break;
    case Fault::kTurnLess:
      *measurements.lengths[cable] -= turn;
      break;
  }
  return measurements;
}

struct Outcome {
  double size = 0.0;     // of the fault, in standard deviations of the measurement
  double visible = 0.0;  // and what of it shows in its residual, in the residual's standard deviations
  // From the clean estimate, largest component: in standard deviations of that, and of the estimate itself.
  double distance = 0.0;
  double own_distance = 0.0;
  bool solved = false, flagged = false, others = false;
};

// How the estimate with a fault compares with the clean one.
Outcome compare(const SimulatedRobot& robot, Fault fault, std::size_t cable, const CableMeasurements& clean,
                const CableMeasurements& faulty, const Estimate& expected, const Estimate& found) {
  Outcome outcome;
  const double redundancy = ofLength(fault) ? expected.length_redundancy[cable] : expected.tension_redundancy[cable];
  outcome.size = ofLength(fault)
                     ? std::abs(*faulty.lengths[cable] - *clean.lengths[cable]) / robot.estimator.length_stddev
                     : std::abs(*faulty.tensions[cable] - *clean.tensions[cable]) / robot.estimator.tension_stddev;
  outcome.visible = outcome.size * std::sqrt(redundancy);
  outcome.solved = found.solution.report.status.ok();
  if (!outcome.solved) return outcome;
  outcome.flagged = ofLength(fault) ? found.length_outlier[cable] : found.tension_outlier[cable];
  for (std::size_t i = 0; i < found.length_outlier.size(); ++i) {
    const bool this_one = i == cable;
    outcome.others |= found.length_outlier[i] && !(this_one && ofLength(fault));
    outcome.others |= found.tension_outlier[i] && !(this_one && !ofLength(fault));
  }
  outcome.others |= found.load_outlier.any();
  const Wrench shift = poseError(found.solution.pose, expected.solution.pose);
  for (int k = 0; k < robot.robot.freedoms(); ++k) {
    outcome.distance = std::max(outcome.distance, std::abs(shift(k)) / sigma(expected.covariance, k));
    outcome.own_distance = std::max(outcome.own_distance, std::abs(shift(k)) / sigma(found.covariance, k));
  }
  return outcome;
}

// Measurements on a straight way between two poses; empty if the cables cannot hold them all.
std::vector<CableMeasurements> drive(SimulatedRobot* robot) {
  moveToRandomPose(robot);
  const Pose from = robot->truth.pose;
  const Eigen::Vector3d way =
      kFar * robot->robot.span() *
      (robot->robot.type == PlatformType::kPointMass ? Eigen::Vector3d(0.8, 0.0, 0.6) : robot->dice.direction());
  std::vector<CableMeasurements> measurements;
  for (int k = 0; k <= kSteps; ++k) {
    if (!robot->moveTo(displaced(from, way * k / kSteps, Eigen::Vector3d::Zero()))) return {};
    measurements.push_back(robot->measure(robot->truth, 1.0));
  }
  return measurements;
}

struct Tally {
  int cases = 0, flagged = 0, visible = 0, visible_flagged = 0, within = 0, within_own = 0, others = 0, failed = 0;
  std::vector<double> distances;

  void add(const Outcome& outcome, double threshold) {
    if (outcome.size <= threshold) return;
    ++cases;
    if (!outcome.solved) {
      ++failed;
      return;
    }
    flagged += static_cast<int>(outcome.flagged);
    others += static_cast<int>(outcome.others);
    within += static_cast<int>(outcome.distance <= 3.0);
    within_own += static_cast<int>(outcome.own_distance <= 3.0);
    distances.push_back(outcome.distance);
    if (outcome.visible <= threshold + 3.0) return;  // noise of three standard deviations may hide it
    ++visible;
    visible_flagged += static_cast<int>(outcome.flagged);
  }

  void print(const std::string& label) const {
    const auto percent = [](int part, int of) { return of == 0 ? 0.0 : 100.0 * part / of; };
    std::printf("| %s | %d | %.1f %% | %d | %.1f %% | %.1f %% | %.1f %% | %.1f %% | %.2f | %d |\n", label.c_str(),
                cases, percent(flagged, cases), visible, percent(visible_flagged, visible), percent(others, cases),
                percent(within, cases), percent(within_own, cases), quantile(distances, 0.5), failed);
  }
};

void heading(const char* first) {
  std::printf("\n| %s | beyond 6 sigma | flagged | of these visible | flagged | something else flagged ", first);
  std::printf("| within 3 sigma of clean | of its own | median distance | no estimate |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
}

}  // namespace

void studyFaults(const Study& study) {
  CsvFile csv(study.directory + "/faults.csv",
              "robot,fault,onset,drive,cable,size,visible,solved,flagged,others,distance,own_distance");
  std::map<std::string, Tally> by_fault, by_robot;
  for (const std::string& name : robots()) {
    SimulatedRobot robot = simulated(study, name);
    const double turn = kTurn * robot.robot.span();
    const int drives = study.quick ? 2 : 10;
    for (int d = 0; d < drives; ++d) {
      std::vector<CableMeasurements> clean;
      while (clean.empty()) clean = drive(&robot);
      PoseEstimator reference(robot.robot, robot.estimator);
      Estimate expected;
      for (const CableMeasurements& measurements : clean) expected = reference.update(measurements);
      if (!expected.solution.report.status.ok()) continue;
      for (std::size_t cable = 0; cable < robot.robot.cables.size(); ++cable) {
        for (const Fault fault : kFaults) {
          const CableMeasurements last = withFault(fault, cable, turn, clean.front(), clean.back());
          for (const bool tracking : {true, false}) {
            PoseEstimator estimator(robot.robot, robot.estimator);
            if (tracking) {
              static_cast<void>(estimator.update(clean.front()));
              for (int k = 1; k < kSteps; ++k) {
                static_cast<void>(estimator.update(withFault(fault, cable, turn, clean.front(), clean[k])));
              }
            }
            const Outcome outcome = compare(robot, fault, cable, clean.back(), last, expected, estimator.update(last));
            const char* onset = tracking ? "while tracking" : "from the start";
            const std::string when = std::string(", ") + onset;
            by_fault[nameOf(fault) + when].add(outcome, robot.estimator.outlier_threshold);
            by_robot[name + when].add(outcome, robot.estimator.outlier_threshold);
            csv.row(name, nameOf(fault), onset, d, cable, outcome.size, outcome.visible, outcome.solved,
                    outcome.flagged, outcome.others, outcome.distance, outcome.own_distance);
          }
        }
      }
    }
  }
  heading("fault");
  for (const auto& [label, tally] : by_fault) tally.print(label);
  heading("robot");
  for (const auto& [label, tally] : by_robot) tally.print(label);
}

}  // namespace cdpr_kinetostatics

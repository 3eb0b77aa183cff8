#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>

#include "estimation/adjustment.h"
#include "estimation_study/study.h"
#include "support/csv_file.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kOffsets[] = {0.005, 0.01, 0.02, 0.05, 0.1};  // of one cable [m]
constexpr double kAllOff = 0.005;                              // standard deviation of all lengths at once [m]
constexpr int kPerPose = 20;
constexpr int kMessages = 12;  // while tracking: more than the variance factor's window

// What the others see of a fault, in deviations, from which on noise cannot hide it; and below which nobody sees it.
constexpr double kVisible = 9.0;
constexpr double kHidden = 3.0;

// The root of the least sum of squares that the offset, without any noise, leaves in a pose near the truth. The first
// order would say more: a large offset bends the robot to where it fits.
double seenOf(const SimulatedRobot& robot, std::size_t cable, double offset) {
  CableMeasurements measurements;
  RobotForces truth;
  truth.pose = robot.truth.pose;
  for (const CableResult& result : robot.truth.cables) {
    measurements.lengths.emplace_back(result.cable.length);
    measurements.tensions.emplace_back(result.cable.tension_a);
    truth.lengths.push_back(result.cable.length);
    truth.forces.push_back({result.cable.horizontal_force, result.cable.vertical_force_a});
  }
  *measurements.lengths[cable] += offset;
  const std::size_t n = robot.robot.cables.size();
  Selection all{std::vector<bool>(n, true), std::vector<bool>(n, true)};
  all.load.head(robot.robot.freedoms()).setConstant(true);
  const Adjusted adjusted =
      adjust(robot.robot, robot.estimator, measurements, all, std::vector<Model>(n, robot.estimator.model), truth,
             std::chrono::steady_clock::now() + std::chrono::minutes(1));
  return adjusted.status.ok() ? std::sqrt(adjusted.weighted_squares) : kHidden;
}

struct Tally {
  int cases = 0, position = 0, rotation = 0, visible = 0, named = 0, flagged = 0, ambiguous = 0, failed = 0;
  double squares = 0.0;

  // cable: at fault, or none.
  void add(const SimulatedRobot& robot, const Estimate& estimate, std::optional<std::size_t> cable, double seen) {
    if (!estimate.solution.report.status.ok()) {
      ++failed;
      return;
    }
    ++cases;
    const int n = robot.robot.freedoms();
    const Wrench error = poseError(estimate.solution.pose, robot.truth.pose);
    squares += error.head(n).dot(estimate.covariance.topLeftCorner(n, n).ldlt().solve(error.head(n))) / n;
    const auto within = [&](int from) {
      bool all = true;
      for (int k = from; k < from + 3; ++k) all &= std::abs(error(k)) <= 3.0 * sigma(estimate.covariance, k);
      return static_cast<int>(all);
    };
    position += within(0);
    rotation += n == 6 ? within(3) : 1;
    const auto any = [](const std::vector<bool>& flags) {
      return std::any_of(flags.begin(), flags.end(), [](bool flag) { return flag; });
    };
    flagged +=
        static_cast<int>(any(estimate.length_outlier) || any(estimate.tension_outlier) || estimate.load_outlier.any());
    ambiguous +=
        static_cast<int>(any(estimate.length_suspect) || any(estimate.tension_suspect) || estimate.load_suspect.any());
    if (!cable || seen < kVisible) return;
    ++visible;
    named += static_cast<int>(estimate.length_outlier[*cable] || estimate.length_suspect[*cable] ||
                              estimate.tension_outlier[*cable] || estimate.tension_suspect[*cable]);
  }

  void add(const Tally& other) {
    cases += other.cases;
    position += other.position;
    rotation += other.rotation;
    visible += other.visible;
    named += other.named;
    flagged += other.flagged;
    ambiguous += other.ambiguous;
    failed += other.failed;
    squares += other.squares;
  }

  void print(const std::string& label) const {
    if (cases + failed == 0) return;
    const auto percent = [](int part, int of) { return of == 0 ? 0.0 : 100.0 * part / of; };
    std::printf("| %s | %d | %.2f | %.1f %% | %.1f %% | %.1f %% | %.1f %% | ", label.c_str(), cases,
                cases == 0 ? 0.0 : squares / cases, percent(position, cases), percent(rotation, cases),
                percent(flagged, cases), percent(ambiguous, cases));
    if (visible > 0) std::printf("%.1f %%", percent(named, visible));
    std::printf(" | %d |\n", failed);
  }
};

void heading(const char* first) {
  std::printf("\n| %s | cases | mean error^2 / freedoms | position within 3 sigma | rotation | something flagged ",
              first);
  std::printf("| not told apart | cable named | no estimate |\n|---|---|---|---|---|---|---|---|---|---|\n");
}

using Disturb = std::function<CableMeasurements(CableMeasurements)>;

// The first message of an estimator, and one after others with the same disturbance, the platform at rest.
Estimate firstOf(SimulatedRobot* robot, const RobotSolution& state, const Disturb& disturb) {
  return PoseEstimator(robot->robot, robot->estimator).update(disturb(robot->measure(state, 1.0)));
}

Estimate laterOf(SimulatedRobot* robot, const RobotSolution& state, const Disturb& disturb) {
  PoseEstimator estimator(robot->robot, robot->estimator);
  static_cast<void>(estimator.update(robot->measure(state, 1.0)));
  Estimate last;
  for (int k = 0; k < kMessages; ++k) last = estimator.update(disturb(robot->measure(state, 1.0)));
  return last;
}

constexpr const char* kShares[] = {"hidden", "between", "visible"};
using Tallies = std::array<Tally, 3>;

void sampleOffsets(SimulatedRobot* robot, CsvFile* csv, Tallies* first, Tallies* later) {
  const RobotSolution state = robot->truth;
  for (std::size_t cable = 0; cable < robot->robot.cables.size(); ++cable) {
    for (const double size : kOffsets) {
      for (const double sign : {1.0, -1.0}) {
        const Disturb disturb = [&](CableMeasurements measurements) {
          *measurements.lengths[cable] += sign * size;
          return measurements;
        };
        const double seen = seenOf(*robot, cable, sign * size);
        const std::size_t share = seen < kHidden ? 0 : seen < kVisible ? 1 : 2;
        for (const bool tracking : {false, true}) {
          const Estimate estimate = tracking ? laterOf(robot, state, disturb) : firstOf(robot, state, disturb);
          Tally one;
          one.add(*robot, estimate, cable, seen);
          (tracking ? later : first)->at(share).add(*robot, estimate, cable, seen);
          csv->row(robot->robot.name, tracking ? "later" : "first", cable, sign * size, seen, one.cases, one.squares,
                   one.position, one.rotation, one.flagged, one.ambiguous, one.named);
        }
      }
    }
  }
}

void studyOneOff(const Study& study) {
  CsvFile csv(study.directory + "/offsets.csv",
              "robot,onset,cable,offset,seen,solved,squares,position,rotation,flagged,ambiguous,named");
  heading("robot | offset");
  Tallies all_first, all_later;
  for (const std::string& name : robots()) {
    SimulatedRobot robot = simulated(study, name);
    Tallies first, later;
    for (int p = 0; p < (study.quick ? 3 : 20); ++p) {
      moveToRandomPose(&robot);
      sampleOffsets(&robot, &csv, &first, &later);
    }
    for (std::size_t share = 0; share < first.size(); ++share) {
      const std::string label = "`" + name + "` | " + kShares[share];
      first[share].print(label + ", first message");
      later[share].print(label + ", later");
      all_first[share].add(first[share]);
      all_later[share].add(later[share]);
    }
  }
  Tally any_first, any_later;
  for (std::size_t share = 0; share < all_first.size(); ++share) {
    all_first[share].print(std::string("all | ") + kShares[share] + ", first message");
    all_later[share].print(std::string("all | ") + kShares[share] + ", later");
    any_first.add(all_first[share]);
    any_later.add(all_later[share]);
  }
  any_first.print("all | any, first message");
  any_later.print("all | any, later");
}

void studyAllOff(const Study& study) {
  heading("robot | all lengths off, in deviations");
  for (const std::string& name : robots()) {
    SimulatedRobot robot = simulated(study, name);
    Tally first, later;
    for (int p = 0; p < (study.quick ? 3 : 20); ++p) {
      moveToRandomPose(&robot);
      const Disturb disturb = [&](CableMeasurements measurements) {
        for (auto& length : measurements.lengths) *length += kAllOff * robot.dice.normal();
        return measurements;
      };
      for (int k = 0; k < kPerPose; ++k) {
        first.add(robot, firstOf(&robot, robot.truth, disturb), {}, 0.0);
        later.add(robot, laterOf(&robot, robot.truth, disturb), {}, 0.0);
      }
    }
    char size[16];
    std::snprintf(size, sizeof size, "%.2g", kAllOff / robot.estimator.length_stddev);
    first.print("`" + name + "` | " + size + ", first message");
    later.print("`" + name + "` | " + size + ", later");
  }
}

}  // namespace

void studyOffsets(const Study& study) {
  studyOneOff(study);
  studyAllOff(study);
}

}  // namespace cdpr_kinetostatics

#include "estimation/fault_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measured_truth.h"
#include "simulated_measurements.h"

namespace cdpr_kinetostatics {
namespace {

TEST(FaultSearch, LeavesOutTheFaultyMeasurementAndNoOther) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  for (std::size_t i = 0; i < simulated.robot.cables.size(); ++i) {
    CableMeasurements measurements = simulated.measure(simulated.truth, 1.0);
    *measurements.tensions[i] += 60.0 * simulated.estimator.tension_stddev;
    const MeasuredRobot measured = measuredBy(simulated, measurements);
    const Candidate found = leaveOutFaults(measured, truthOf(simulated), measured.available);
    ASSERT_TRUE(found.adjusted.status.ok()) << found.adjusted.status.message;
    const Selection left_out = leftOut(measured, found);
    for (std::size_t k = 0; k < simulated.robot.cables.size(); ++k) {
      EXPECT_FALSE(left_out.lengths[k]) << i << " " << k;
      EXPECT_EQ(left_out.tensions[k], k == i) << i << " " << k;
    }
    EXPECT_FALSE(left_out.load.any()) << i;
    EXPECT_TRUE(isNoise(found));
    EXPECT_FALSE(isBeyondDoubt(measured, found));
  }
}

TEST(FaultSearch, TakesBackWhatWasLeftOutAndAgreesNow) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements measurements = simulated.measure(simulated.truth, 1.0);
  const MeasuredRobot measured = measuredBy(simulated, measurements);
  const std::size_t n = simulated.robot.cables.size();
  Selection before{std::vector<bool>(n, false), std::vector<bool>(n, false)};
  before.lengths[1] = before.tensions[3] = true;
  before.load(2) = true;
  const Candidate found = adjustFrom(measured, truthOf(simulated), before);
  ASSERT_TRUE(found.adjusted.status.ok()) << found.adjusted.status.message;
  const Selection left_out = leftOut(measured, found);
  EXPECT_EQ(std::count(left_out.lengths.begin(), left_out.lengths.end(), true), 0);
  EXPECT_EQ(std::count(left_out.tensions.begin(), left_out.tensions.end(), true), 0);
  EXPECT_FALSE(left_out.load.any());
}

// Only what is stable, leaves nothing out and has no more squares than noise makes needs no other start beside it.
TEST(FaultSearch, DoubtsWhatDoesNotExplainAll) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements measurements = simulated.measure(simulated.truth, 1.0);
  const MeasuredRobot measured = measuredBy(simulated, measurements);
  const Candidate good = leaveOutFaults(measured, truthOf(simulated), measured.available);
  EXPECT_TRUE(isNoise(good));
  EXPECT_TRUE(isBeyondDoubt(measured, good));
  Candidate doubtful = good;
  doubtful.adjusted.stable = false;
  EXPECT_FALSE(isNoise(doubtful));
  doubtful = good;
  doubtful.adjusted.weighted_squares = 8.0 + 6.0 * std::sqrt(16.0) + 5.0;  // of 8 redundant measurements
  EXPECT_FALSE(isNoise(doubtful));
  doubtful = good;
  doubtful.selection.lengths[2] = false;
  EXPECT_TRUE(isNoise(doubtful));
  EXPECT_FALSE(isBeyondDoubt(measured, doubtful));
}

// In this order: an answer at all, one that explains the measurements, stability, redundancy, sum of squares.
TEST(FaultSearch, PrefersTheBetterAnswer) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
  const MeasuredRobot measured = measuredBy(simulated, measurements);
  Candidate good;
  good.adjusted.status.code = Code::kConverged;
  good.adjusted.stable = true;
  good.adjusted.redundancy = 8;
  good.adjusted.weighted_squares = 7.0;
  const auto expectWorse = [&](const Candidate& worse, const char* why) {
    EXPECT_TRUE(isBetter(measured, good, worse)) << why;
    EXPECT_FALSE(isBetter(measured, worse, good)) << why;
  };
  expectWorse(Candidate(), "never tried");
  Candidate worse = good;
  worse.adjusted.status.code = Code::kNotConverged;
  expectWorse(worse, "no answer");
  worse = good;
  worse.adjusted.weighted_squares = 1e9;
  worse.adjusted.redundancy = 20;
  expectWorse(worse, "explains nothing");
  worse = good;
  worse.adjusted.stable = false;
  worse.adjusted.redundancy = 20;
  expectWorse(worse, "unstable");
  worse = good;
  worse.adjusted.redundancy = 7;
  worse.adjusted.weighted_squares = 1.0;
  expectWorse(worse, "left more out");
  worse = good;
  worse.adjusted.weighted_squares = 7.5;
  expectWorse(worse, "more squares");
  EXPECT_FALSE(isBetter(measured, good, good));
}

struct Fault {
  const char* name;
  bool length;
  double value;  // added to the length [m], or factor of the tension
};

class FaultyCable : public ::testing::TestWithParam<const char*> {};

// A drum turn of 0.3 m, scaled to robots smaller or larger than 10 m; a cell that reads 30 % off, or nothing.
TEST_P(FaultyCable, IsFlaggedAndTheEstimateStays) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, GetParam());
  const double turn = 0.03 * simulated.robot.span();
  for (const Fault& fault : {Fault{"drum turn", true, turn}, Fault{"drum turn back", true, -turn},
                             Fault{"biased cell", false, 1.3}, Fault{"dead cell", false, 0.0}}) {
    for (std::size_t i = 0; i < simulated.robot.cables.size(); ++i) {
      const CableMeasurements clean = simulated.measure(simulated.truth, 1.0);
      CableMeasurements faulty = clean;
      if (fault.length) {
        *faulty.lengths[i] += fault.value;
      } else {
        *faulty.tensions[i] *= fault.value;
      }
      const double size =
          std::abs(fault.length ? fault.value / simulated.estimator.length_stddev
                                : (fault.value - 1.0) * *clean.tensions[i] / simulated.estimator.tension_stddev);
      PoseEstimator good(simulated.robot, simulated.estimator);
      PoseEstimator tested(simulated.robot, simulated.estimator);
      const Estimate expected = good.update(clean);
      ASSERT_TRUE(expected.solution.report.status.ok());
      // A cable that is nearly slack takes up a drum's turn in its sag, and its tension hardly tells.
      if (fault.length &&
          *clean.tensions[i] < 2.0 * simulated.estimator.outlier_threshold * simulated.estimator.tension_stddev) {
        continue;
      }
      const double redundancy = fault.length ? expected.length_redundancy[i] : expected.tension_redundancy[i];
      if (size * std::sqrt(redundancy) < 1.5 * simulated.estimator.outlier_threshold) continue;  // lost in noise
      ASSERT_TRUE(tested.update(clean).solution.report.status.ok());
      const Estimate estimate = tested.update(faulty);
      ASSERT_TRUE(estimate.solution.report.status.ok())
          << fault.name << " of cable " << i << ": " << estimate.solution.report.status.message;
      EXPECT_TRUE(fault.length ? estimate.length_outlier[i] : estimate.tension_outlier[i])
          << fault.name << " of cable " << i;
      const Wrench shift = poseError(estimate.solution.pose, expected.solution.pose);
      for (int k = 0; k < simulated.robot.freedoms(); ++k) {
        EXPECT_LT(std::abs(shift(k)), 3.0 * std::sqrt(expected.covariance(k, k) + estimate.covariance(k, k)))
            << fault.name << " of cable " << i << ", component " << k;
      }
      // And it comes back when the fault is gone.
      const Estimate after = tested.update(clean);
      EXPECT_FALSE(after.length_outlier[i] || after.tension_outlier[i]) << fault.name << " of cable " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Redundant, FaultyCable,
                         ::testing::Values("cogiro", "ipanema3", "caroca", "desktop_music_wire"));

TEST(FaultSearch, FindsAPayloadThatItWasNotToldOf) {
  for (const bool known : {true, false}) {
    SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
    simulated.estimator.known_load = known;
    Wrench payload = Wrench::Zero();
    payload(2) = -0.2 * simulated.robot.weight();
    const RobotSolution truth = simulated.under(payload);
    ASSERT_TRUE(truth.report.status.ok());
    PoseEstimator estimator(simulated.robot, simulated.estimator);
    const Estimate estimate = estimator.update(simulated.measure(truth, 0.0));
    ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
    EXPECT_NEAR(estimate.load(2), payload(2), 1e-3 * simulated.robot.weight()) << known;
    EXPECT_EQ(estimate.load_outlier(2), known);
    EXPECT_LT((estimate.solution.pose.position - truth.pose.position).norm(), 1e-4) << known;
  }
}

TEST(FaultSearch, RemembersAPayloadUntilItIsGone) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  Wrench payload = Wrench::Zero();
  payload(2) = -0.2 * simulated.robot.weight();
  const RobotSolution loaded = simulated.under(payload);
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  ASSERT_TRUE(estimator.update(simulated.measure(simulated.truth, 1.0)).solution.report.status.ok());
  for (int i = 0; i < 3; ++i) {
    const Estimate estimate = estimator.update(simulated.measure(loaded, 1.0));
    ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
    EXPECT_TRUE(estimate.load_outlier(2)) << i;
    EXPECT_TRUE(estimate.warm_started) << i;
    EXPECT_NEAR(estimate.load(2), payload(2), 4.0 * std::sqrt(estimate.load_covariance(2, 2))) << i;
  }
  const Estimate unloaded = estimator.update(simulated.measure(simulated.truth, 1.0));
  EXPECT_FALSE(unloaded.load_outlier.any());
}

}  // namespace
}  // namespace cdpr_kinetostatics

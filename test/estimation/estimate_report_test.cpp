#include "estimation/estimate_report.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "simulated_measurements.h"

namespace cdpr_kinetostatics {
namespace {

TEST(EstimateReport, SaysWhichDirectionsTheDataLeaveOpen) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "scampi");
  simulated.estimator.known_load = false;
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  const Estimate estimate = estimator.update(simulated.measure(simulated.truth, 0.0));
  ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
  EXPECT_EQ(estimate.unobservable_directions, 2);
  EXPECT_GE(estimate.load_unknown.count(), 2);
  EXPECT_TRUE(estimate.load_covariance.allFinite());
  EXPECT_NE(estimate.solution.report.status.message.find("2 direction"), std::string::npos);
  EXPECT_TRUE(estimate.covariance.allFinite());
}

// The platform's frame is any frame: turned far against the world, the covariance in world axes must not notice.
TEST(EstimateReport, CovarianceIsThatOfSmallErrorsOfTheMeasurementsInWorldAxes) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.2, Eigen::Vector3d(0.4, -0.8, 0.5).normalized()));
  for (CableDescription& cable : simulated.robot.cables) cable.attachment = turn.conjugate() * cable.attachment;
  simulated.robot.com = turn.conjugate() * simulated.robot.com;
  simulated.robot.home.orientation = simulated.robot.home.orientation * turn;
  ASSERT_TRUE(simulated.moveTo({simulated.truth.pose.position, simulated.truth.pose.orientation * turn}));
  simulated.estimator.known_load = false;
  const CableMeasurements clean = simulated.measure(simulated.truth, 0.0);
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  const Estimate estimate = estimator.update(clean);
  ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;

  constexpr double kStep = 1e-2;  // standard deviations
  const auto effect = [&](bool of_length, std::size_t i) {
    const auto moved = [&](double step) {
      CableMeasurements m = clean;
      (of_length ? *m.lengths[i] : *m.tensions[i]) +=
          step * (of_length ? simulated.estimator.length_stddev : simulated.estimator.tension_stddev);
      PoseEstimator another(simulated.robot, simulated.estimator);
      return poseError(another.update(m).solution.pose, simulated.truth.pose);
    };
    return Wrench((moved(kStep) - moved(-kStep)) / (2.0 * kStep));
  };
  Eigen::Matrix<double, 6, 6> expected = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t i = 0; i < simulated.robot.cables.size(); ++i) {
    for (const bool of_length : {true, false}) {
      const Wrench d = effect(of_length, i);
      expected += d * d.transpose();
    }
  }
  for (int k = 0; k < 6; ++k) {
    for (int l = 0; l < 6; ++l) {
      const double scale = std::sqrt(expected(k, k) * expected(l, l));
      EXPECT_NEAR(estimate.covariance(k, l), expected(k, l), 1e-3 * scale) << k << " " << l;
    }
  }
}

TEST(EstimateReport, SaysThatTheLoadIsUnknownIfACableIsSilent) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
  measurements.lengths[0].reset();
  measurements.tensions[0].reset();
  for (const bool known : {true, false}) {
    simulated.estimator.known_load = known;
    PoseEstimator estimator(simulated.robot, simulated.estimator);
    const Estimate estimate = estimator.update(measurements);
    ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
    EXPECT_EQ(estimate.unobservable_directions, 0);
    EXPECT_EQ(estimate.load_unknown.all(), !known);
    EXPECT_TRUE(estimate.load_covariance.allFinite());
  }
}

// A drum of CoGiRo's is 50 mm off, which several cables explain: the right one is among those named, and the truth
// within three of the estimate's own deviations, in the first message and later.
TEST(EstimateReport, NamesAllThatMayBeAtFaultAndCoversTheirAnswers) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  int ambiguous = 0;
  for (std::size_t cable = 0; cable < simulated.robot.cables.size(); ++cable) {
    PoseEstimator estimator(simulated.robot, simulated.estimator);
    for (const char* when : {"first", "later"}) {
      CableMeasurements measurements = simulated.measure(simulated.truth, 1.0);
      *measurements.lengths[cable] += 0.05;
      const Estimate estimate = estimator.update(measurements);
      ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
      EXPECT_TRUE(estimate.length_outlier[cable] || estimate.length_suspect[cable]) << when << " " << cable;
      const Wrench error = poseError(estimate.solution.pose, simulated.truth.pose);
      for (int k = 0; k < 6; ++k) {
        EXPECT_LT(std::abs(error(k)), 3.0 * std::sqrt(estimate.covariance(k, k))) << when << " " << cable << " " << k;
      }
      const std::string& message = estimate.solution.report.status.message;
      for (std::size_t i = 0; i < simulated.robot.cables.size(); ++i) {
        if (!estimate.length_suspect[i]) continue;
        ++ambiguous;
        EXPECT_FALSE(estimate.length_outlier[i]);
        EXPECT_NE(message.find("length of " + simulated.robot.cables[i].name), std::string::npos) << message;
      }
    }
  }
  EXPECT_GT(ambiguous, 0);
}

// All lengths off by 5 mm at random: the deviation that counts is the one that the messages show.
TEST(EstimateReport, WidensTheDeviationsThatMeasurementsExceed) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  EXPECT_EQ(estimator.update(simulated.measure(simulated.truth, 1.0)).deviation_factors.lengths, 1.0);
  const double times = 0.005 / simulated.estimator.length_stddev;
  double squares = 0.0, factors = 0.0;
  constexpr int kSettle = 10, kMessages = 200;
  for (int k = 0; k < kSettle + kMessages; ++k) {
    CableMeasurements measurements = simulated.measure(simulated.truth, 1.0);
    for (auto& length : measurements.lengths) *length += 0.005 * simulated.dice.normal();
    const Estimate estimate = estimator.update(measurements);
    ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
    if (k < kSettle) continue;
    const Wrench error = poseError(estimate.solution.pose, simulated.truth.pose);
    squares += error.dot(estimate.covariance.ldlt().solve(error)) / 6.0 / kMessages;
    factors += estimate.deviation_factors.lengths / kMessages;
  }
  EXPECT_LT(squares, 1.5);
  EXPECT_NEAR(factors, times, 0.3 * times);  // a window's spread, and what is left out lowers it
}

}  // namespace
}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/estimation/pose_estimator.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "pulley_robots.h"
#include "simulated_measurements.h"

namespace cdpr_kinetostatics {
namespace {

class EveryRobot : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryRobot, WithoutNoiseFindsThePoseTheForcesAndNoLoad) {
  for (const Model model : {Model::kCatenary, Model::kBending}) {
    SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, GetParam(), model);
    PoseEstimator estimator(simulated.robot, simulated.estimator);
    const Estimate estimate = estimator.update(simulated.measure(simulated.truth, 0.0));
    ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
    EXPECT_FALSE(estimate.warm_started);
    EXPECT_LT(poseError(estimate.solution.pose, simulated.truth.pose).norm(), 1e-7);
    EXPECT_LT(estimate.load.head<3>().norm(), 1e-5 * simulated.robot.weight());
    EXPECT_EQ(estimate.unobservable_directions, 0);
    for (std::size_t i = 0; i < simulated.robot.cables.size(); ++i) {
      EXPECT_NEAR(estimate.solution.cables[i].cable.tension_a, simulated.truth.cables[i].cable.tension_a,
                  1e-5 * simulated.robot.weight());
      EXPECT_FALSE(estimate.length_outlier[i] || estimate.tension_outlier[i]);
    }
  }
}

// Tracked while it moves; with the pulleys left out of the description the same messages lead elsewhere.
TEST(RobotsOnGuidePulleys, AreTrackedWithoutErrorIfTheirPulleysAreDescribed) {
  for (const char* name : {"cogiro", "ipanema3"}) {
    const RobotDescription bare = shippedRobot(ROBOT_DIR, name);
    for (const Model model : {Model::kCatenary, Model::kBending}) {
      SCOPED_TRACE(testing::Message() << name << " " << modelName(model));
      SimulatedRobot simulated = simulatedRobot(withPulleys(bare, 0.04, 5.0), model);
      PoseEstimator knowing(simulated.robot, simulated.estimator);
      PoseEstimator ignorant(bare, simulated.estimator);
      const Pose start = simulated.truth.pose;
      for (int i = 0; i < 10; ++i) {
        Pose pose = start;
        pose.position.x() += 0.005 * i;
        ASSERT_TRUE(simulated.moveTo(pose));
        const CableMeasurements exact = simulated.measure(simulated.truth, 0.0);
        const Estimate estimate = knowing.update(exact);
        ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
        EXPECT_LT(poseError(estimate.solution.pose, simulated.truth.pose).norm(), 1e-7);
        EXPECT_LT(estimate.load.head<3>().norm(), 1e-5 * simulated.robot.weight());
        const Estimate wrong = ignorant.update(exact);
        EXPECT_FALSE(wrong.solution.report.status.ok() &&
                     poseError(wrong.solution.pose, simulated.truth.pose).norm() < 5e-3);
      }
    }
  }
}

TEST_P(EveryRobot, LengthsAloneGiveForwardKinetostaticsWithACovariance) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, GetParam());
  CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
  for (auto& tension : measurements.tensions) tension.reset();
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  const Estimate estimate = estimator.update(measurements);
  ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
  EXPECT_LT(poseError(estimate.solution.pose, simulated.truth.pose).norm(), 1e-6);
  EXPECT_EQ(estimate.redundancy, 0);
  EXPECT_EQ(estimate.unobservable_directions, 0);
  EXPECT_GT(estimate.covariance.diagonal().head<3>().minCoeff(), 0.0);
  EXPECT_LT(estimate.covariance.diagonal().head<3>().maxCoeff(), std::pow(0.1 * simulated.robot.span(), 2));
}

TEST_P(EveryRobot, CovariancePredictsTheError) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, GetParam());
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  const int n = simulated.robot.freedoms();
  constexpr int kSamples = 2000;
  double nees = 0.0;
  double load_nees = 0.0;
  int outliers = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Wrench load = simulated.randomLoad();
    const RobotSolution truth = simulated.under(load);
    ASSERT_TRUE(truth.report.status.ok()) << truth.report.status.message;
    const Estimate estimate = estimator.update(simulated.measure(truth, 1.0));
    ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
    const Wrench error = poseError(estimate.solution.pose, truth.pose);
    nees += error.head(n).dot(estimate.covariance.topLeftCorner(n, n).ldlt().solve(error.head(n)));
    const Wrench load_error = estimate.load - load;
    load_nees += load_error.head(n).dot(estimate.load_covariance.topLeftCorner(n, n).ldlt().solve(load_error.head(n)));
    for (std::size_t k = 0; k < simulated.robot.cables.size(); ++k) {
      outliers += static_cast<int>(estimate.length_outlier[k]) + static_cast<int>(estimate.tension_outlier[k]);
    }
  }
  EXPECT_NEAR(nees / kSamples, n, 0.05 * n);
  EXPECT_NEAR(load_nees / kSamples, n, 0.05 * n);
  EXPECT_EQ(outliers, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, EveryRobot,
                         ::testing::Values("cogiro", "ipanema3", "caroca", "desktop_music_wire", "scampi",
                                           "paper_point_mass", "fast"));

TEST(PoseEstimator, MissingMeasurementsAreDoneWithout) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
  measurements.tensions[1].reset();
  measurements.lengths[4].reset();
  measurements.lengths[6].reset();
  measurements.tensions[6].reset();
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  const Estimate estimate = estimator.update(measurements);
  ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
  EXPECT_LT(poseError(estimate.solution.pose, simulated.truth.pose).norm(), 1e-6);
}

TEST(PoseEstimator, SameMeasurementsAfterResetGiveTheSameEstimateBitForBit) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  std::vector<CableMeasurements> stream;
  for (int i = 0; i < 20; ++i) stream.push_back(simulated.measure(simulated.truth, 1.0));
  std::vector<Pose> first;
  for (const CableMeasurements& m : stream) first.push_back(estimator.update(m).solution.pose);
  estimator.reset();
  for (std::size_t i = 0; i < stream.size(); ++i) {
    const Pose again = estimator.update(stream[i]).solution.pose;
    EXPECT_EQ(again.position, first[i].position);
    EXPECT_EQ(again.orientation.coeffs(), first[i].orientation.coeffs());
  }
}

TEST(PoseEstimator, RefusesImpossibleMeasurementsWithASentence) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
  measurements.lengths[2] = -1.0;
  const Estimate estimate = estimator.update(measurements);
  EXPECT_EQ(estimate.solution.report.status.code, Code::kInvalidInput);
  EXPECT_NE(estimate.solution.report.status.message.find(simulated.robot.cables[2].name), std::string::npos);
  measurements.lengths.pop_back();
  EXPECT_EQ(estimator.update(measurements).solution.report.status.code, Code::kInvalidInput);
}

// As when a drum's radius is wrong, or millimetres are sent for metres.
TEST(PoseEstimator, SaysWhyThereIsNoEstimate) {
  int failed = 0;
  for (const Model model : {Model::kCatenary, Model::kBending, Model::kAuto}) {
    for (const char* name : {"cogiro", "paper_point_mass"}) {
      SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, name);
      simulated.estimator.model = model;
      simulated.estimator.timeout = std::chrono::duration<double>(0.5);
      for (const double factor : {1e-6, 0.5, 1.5}) {
        CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
        for (auto& length : measurements.lengths) *length *= factor;
        PoseEstimator estimator(simulated.robot, simulated.estimator);
        for (int k = 0; k < 2; ++k) {
          const Status status = estimator.update(measurements).solution.report.status;
          failed += !status.ok();
          if (status.ok()) continue;
          EXPECT_NE(status.code, Code::kUnset) << name << ", lengths x " << factor;
          EXPECT_FALSE(status.message.empty()) << name << ", lengths x " << factor;
        }
      }
    }
  }
  EXPECT_GT(failed, 0);
}

TEST(PoseEstimator, ReadingBelowZeroIsAMeasurement) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements clean = simulated.measure(simulated.truth, 0.0);
  const auto slackest =
      static_cast<std::size_t>(std::min_element(clean.tensions.begin(), clean.tensions.end()) - clean.tensions.begin());
  for (const double below : {1.0, 4.0}) {  // standard deviations
    CableMeasurements measurements = clean;
    // A cell whose zero is off, so that it reads less than nothing, is as good as one that is off elsewhere.
    simulated.estimator.tension_stddev = *clean.tensions[slackest] / (below - 0.5);
    measurements.tensions[slackest] = *clean.tensions[slackest] - below * simulated.estimator.tension_stddev;
    ASSERT_LT(*measurements.tensions[slackest], 0.0);
    PoseEstimator estimator(simulated.robot, simulated.estimator);
    const Estimate estimate = estimator.update(measurements);
    ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
    EXPECT_FALSE(estimate.tension_outlier[slackest]);
    EXPECT_GT(estimate.solution.cables[slackest].cable.tension_a, 0.0);
    EXPECT_LT(estimate.tension_residual[slackest], 0.0);
    const Wrench error = poseError(estimate.solution.pose, simulated.truth.pose);
    EXPECT_LT(error.dot(estimate.covariance.ldlt().solve(error)), below * below);
  }
  // A cell that reads nonsense is at fault, whatever the sign.
  simulated.estimator.tension_stddev = 5.0;
  CableMeasurements nonsense = clean;
  nonsense.tensions[slackest] = -3000.0;
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  const Estimate estimate = estimator.update(nonsense);
  ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
  EXPECT_TRUE(estimate.tension_outlier[slackest]);
  nonsense.tensions[slackest] = std::nan("");
  EXPECT_EQ(estimator.update(nonsense).solution.report.status.code, Code::kInvalidInput);
}

TEST(PoseEstimator, TooLittleTimeIsSaidAndDoesNotLast) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements clean = simulated.measure(simulated.truth, 0.0);
  EstimatorOptions hasty = simulated.estimator;
  hasty.timeout = std::chrono::duration<double>(1e-9);
  PoseEstimator estimator(simulated.robot, hasty);
  for (int i = 0; i < 3; ++i) {
    const Estimate estimate = estimator.update(clean);
    EXPECT_EQ(estimate.solution.report.status.code, Code::kTimedOut);
    EXPECT_FALSE(estimate.solution.report.status.message.empty());
    EXPECT_TRUE(isFinite(estimate.solution));
  }
}

TEST(PoseEstimatorOfAnImpossibleRobot, RefusesEveryMessage) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
  simulated.robot.com.x() = std::nan("");
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  const Status status = estimator.update(measurements).solution.report.status;
  EXPECT_EQ(status.code, Code::kInvalidInput);
  EXPECT_NE(status.message.find("com"), std::string::npos) << status.message;
}

}  // namespace
}  // namespace cdpr_kinetostatics

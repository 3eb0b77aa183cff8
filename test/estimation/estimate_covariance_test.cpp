#include "estimation/estimate_covariance.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "measured_truth.h"

namespace cdpr_kinetostatics {
namespace {

class EstimateCovariance : public ::testing::Test {
 protected:
  SimulatedRobot simulated_ = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements measurements_ = simulated_.measure(simulated_.truth, 0.0);
  const MeasuredRobot measured_ = measuredBy(simulated_, measurements_);
  const Candidate best_ = adjust(measured_, truthOf(simulated_), measured_.available);

  Estimate with(const std::vector<Candidate>& rivals) {
    Estimate estimate;
    fillCovariances(simulated_.robot, best_, rivals, &estimate);
    return estimate;
  }
};

TEST_F(EstimateCovariance, IsTheInverseOfTheInformation) {
  const Eigen::MatrixXd product = with({}).covariance * best_.adjusted.information;
  EXPECT_LT((product - Eigen::MatrixXd::Identity(6, 6)).norm(), 1e-6);
}

TEST_F(EstimateCovariance, NoLoadBalancesThePlatformAtTheTruth) {
  const Wrench load = balancingLoad(simulated_.robot, best_.adjusted);
  EXPECT_LT(load.head<3>().norm(), 1e-5 * simulated_.robot.weight());
}

// Rivals as likely as the answer, a metre and half a radian away: the second moment about the answer, by hand.
TEST_F(EstimateCovariance, CoversRivalsByTheirLikelihood) {
  Candidate rival = best_;
  rival.adjusted.unknowns.pose.position += Eigen::Vector3d(0.0, 1.0, 0.0);
  rival.adjusted.unknowns.pose.orientation =
      Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()) * rival.adjusted.unknowns.pose.orientation;
  const Eigen::Matrix<double, 6, 6> alone = with({}).covariance;
  Wrench moved;
  moved << 0.0, 1.0, 0.0, 0.0, 0.0, 0.5;
  const auto expect = [&](double more_squares, double share) {
    rival.adjusted.weighted_squares = best_.adjusted.weighted_squares + more_squares;
    const Eigen::Matrix<double, 6, 6> expected = alone + share * moved * moved.transpose();
    EXPECT_LT((with({rival}).covariance - expected).norm(), 1e-9) << more_squares;
  };
  expect(0.0, 0.5);
  expect(1.0, std::exp(-0.5) / (1.0 + std::exp(-0.5)));
  expect(9.0, 0.25);  // never less: two standard deviations reach the rival
}

TEST_F(EstimateCovariance, WhatOneRivalLeavesOpenIsOpen) {
  Candidate rival = best_;
  rival.adjusted.information.col(0).setZero();
  rival.adjusted.information.row(0).setZero();
  rival.adjusted.load_unknown(2) = true;
  const Estimate estimate = with({rival});
  EXPECT_EQ(estimate.unobservable_directions, 1);
  EXPECT_TRUE(estimate.load_unknown(2));
  EXPECT_GT(estimate.covariance(0, 0), 0.2 * kUnknownVariance);
}

}  // namespace
}  // namespace cdpr_kinetostatics

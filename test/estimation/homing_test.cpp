// Homing: offsets that were put in come out, with deviations that are kept; what does not fit is refused in words.
#include "estimation/homing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pulley_robots.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kSamples = 64;

class HomingTest : public testing::Test {
 protected:
  explicit HomingTest(const RobotDescription& robot = withPulleys(shippedRobot(ROBOT_DIR, "cogiro"), 0.06, 8.0))
      : robot_(robot) {
    options_.model = Model::kCatenary;
    options_.timeout = std::chrono::duration<double>(10.0);
    options_.load_stddev = EstimatorOptions::defaultLoadStddev(robot_);
    const RobotSolution solution = solveInverse(robot_, requestFor(robot_, robot_.home), patient(Model::kCatenary));
    EXPECT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    request_.pose = solution.pose;
    request_.use_tensions = true;
    lengths_ = lengthsOf(solution);
    tensions_ = tensionsOf(solution);
    for (std::size_t i = 0; i < lengths_.size(); ++i) errors_.push_back(0.02 * dice_.normal());
  }

  RestingSamples samples(double noise = 1.0) {
    RestingSamples taken(robot_.cables.size());
    for (int k = 0; k < kSamples; ++k) {
      CableMeasurements measured;
      for (std::size_t i = 0; i < lengths_.size(); ++i) {
        measured.lengths.push_back(lengths_[i] + errors_[i] + noise * options_.length_stddev * dice_.normal());
        measured.tensions.push_back(tensions_[i] + noise * options_.tension_stddev * dice_.normal());
      }
      taken.add(measured);
    }
    return taken;
  }

  const RobotDescription robot_;
  EstimatorOptions options_;
  HomingRequest request_;
  std::vector<double> lengths_, tensions_, errors_;
  Dice dice_{5};
};

class SixCables : public HomingTest {
 protected:
  SixCables() : HomingTest(shippedRobot(ROBOT_DIR, "fast")) {
    options_.tension_stddev = 1000.0;
    request_.use_tensions = false;
  }
};

class FourCables : public HomingTest {
 protected:
  FourCables() : HomingTest(shippedRobot(ROBOT_DIR, "scampi")) { request_.use_tensions = false; }
};

TEST_F(HomingTest, NoiseFreeOffsetsComeOutToTheTolerance) {
  const Homing homing = findHome(robot_, options_, request_, samples(0.0));
  ASSERT_TRUE(homing.report.status.ok()) << homing.report.status.message;
  for (std::size_t i = 0; i < errors_.size(); ++i) EXPECT_NEAR(homing.corrections[i], -errors_[i], 1e-6);
}

// Over many homings the errors have the deviations stated: their mean square is 1 within what 8 x 100 numbers allow.
TEST_F(HomingTest, DeviationsAreThoseOfTheErrors) {
  double squares = 0.0;
  int count = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Homing homing = findHome(robot_, options_, request_, samples());
    ASSERT_TRUE(homing.report.status.ok()) << homing.report.status.message;
    for (std::size_t i = 0; i < errors_.size(); ++i, ++count) {
      squares += std::pow((homing.corrections[i] + errors_[i]) / homing.stddev[i], 2);
    }
  }
  EXPECT_NEAR(squares / count, 1.0, 5.0 * std::sqrt(2.0 / count));
}

// By differences of the length over the measured tension.
TEST_F(HomingTest, TensionNoiseCountsByTheCablesCompliance) {
  options_.length_stddev = 1e-6;
  const Homing before = findHome(robot_, options_, request_, samples(0.0));
  for (double& tension : tensions_) tension += 1.0;
  const Homing after = findHome(robot_, options_, request_, samples(0.0));
  ASSERT_TRUE(before.report.status.ok() && after.report.status.ok());
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const double slope = std::abs(after.corrections[i] - before.corrections[i]);
    const double stddev = slope * options_.tension_stddev / std::sqrt(kSamples);
    EXPECT_NEAR(before.stddev[i], stddev, 0.02 * stddev);
  }
}

TEST_F(HomingTest, APoseThatTheTensionsContradictIsRefused) {
  request_.pose.position.x() += 1.0;
  const Homing homing = findHome(robot_, options_, request_, samples());
  EXPECT_EQ(homing.report.status.code, Code::kInvalidInput);
  EXPECT_NE(homing.report.status.message.find("contradict this pose"), std::string::npos)
      << homing.report.status.message;
  EXPECT_TRUE(homing.corrections.empty());
  options_.known_load = false;
  EXPECT_TRUE(findHome(robot_, options_, request_, samples()).report.status.ok()) << "nothing contradicts it then";
}

TEST_F(HomingTest, MoreCablesThanFreedomsNeedTensions) {
  request_.use_tensions = false;
  const Homing homing = findHome(robot_, options_, request_, samples());
  EXPECT_EQ(homing.report.status.code, Code::kInvalidInput);
  EXPECT_NE(homing.report.status.message.find("8 cables for 6 freedoms"), std::string::npos)
      << homing.report.status.message;
}

TEST_F(HomingTest, AMovingPlatformIsRefused) {
  RestingSamples moving = samples();
  for (double& length : lengths_) length += 0.01;
  for (int k = 0; k < kSamples; ++k) {
    CableMeasurements measured;
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      measured.lengths.push_back(lengths_[i] + errors_[i]);
      measured.tensions.push_back(tensions_[i]);
    }
    moving.add(measured);
  }
  const Homing homing = findHome(robot_, options_, request_, moving);
  EXPECT_EQ(homing.report.status.code, Code::kInvalidInput);
  EXPECT_NE(homing.report.status.message.find("not at rest"), std::string::npos) << homing.report.status.message;
}

TEST_F(SixCables, EquilibriumGivesTheLengths) {
  const Homing homing = findHome(robot_, options_, request_, samples(0.0));
  ASSERT_TRUE(homing.report.status.ok()) << homing.report.status.message;
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    EXPECT_NEAR(homing.corrections[i], -errors_[i], 1e-5);
    EXPECT_NEAR(homing.stddev[i], options_.length_stddev / std::sqrt(kSamples), 1e-12);
  }
}

TEST_F(FourCables, TheAttitudeIsThatOfEquilibrium) {
  request_.pose.orientation = request_.pose.orientation * Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX());
  const Homing homing = findHome(robot_, options_, request_, samples(0.0));
  ASSERT_TRUE(homing.report.status.ok()) << homing.report.status.message;
  for (std::size_t i = 0; i < errors_.size(); ++i) EXPECT_NEAR(homing.corrections[i], -errors_[i], 1e-5);
  request_.pose.orientation = request_.pose.orientation * Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX());
  const Homing tilted = findHome(robot_, options_, request_, samples(0.0));
  EXPECT_EQ(tilted.report.status.code, Code::kInvalidInput);
  EXPECT_NE(tilted.report.status.message.find("would not hang like this"), std::string::npos)
      << tilted.report.status.message;
}

}  // namespace
}  // namespace cdpr_kinetostatics

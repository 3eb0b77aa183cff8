// Averages of measurements at rest, and what tells a moving platform from a resting one.
#include "estimation/resting_samples.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kLengthStddev = 1e-3;
constexpr double kTensionStddev = 5.0;

class Resting : public testing::Test {
 protected:
  // Of all cables; the length of cable 3 moves by so much in each sample.
  void take(int samples, double step = 0.0, double noise = kLengthStddev) {
    for (int k = 0; k < samples; ++k) {
      CableMeasurements measured;
      for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
        measured.lengths.push_back(9.0 + noise * dice_.normal() + (i == 3 ? step * k : 0.0));
        measured.tensions.push_back(300.0 + kTensionStddev * dice_.normal());
      }
      samples_.add(measured);
    }
  }
  Status rest(bool use_tensions = true) const {
    return samples_.checkRest(robot_, use_tensions, kLengthStddev, kTensionStddev);
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  RestingSamples samples_{robot_.cables.size()};
  Dice dice_{11};
};

TEST_F(Resting, MeansAreThoseOfTheSamples) {
  for (const double length : {1.0, 2.0, 6.0}) {
    CableMeasurements measured;
    measured.lengths.assign(robot_.cables.size(), length);
    measured.tensions.assign(robot_.cables.size(), 10.0 * length);
    measured.lengths[2].reset();
    samples_.add(measured);
  }
  EXPECT_EQ(samples_.count(), 3u);
  EXPECT_EQ(samples_.lengthCount(0), 3u);
  EXPECT_EQ(samples_.lengthCount(2), 0u);
  EXPECT_DOUBLE_EQ(samples_.meanLength(0), 3.0);
  EXPECT_DOUBLE_EQ(samples_.meanTension(2), 30.0);
}

TEST_F(Resting, NoiseIsNoMotion) {
  for (int trial = 0; trial < 200; ++trial) {
    samples_ = RestingSamples(robot_.cables.size());
    take(trial % 2 == 0 ? 4 : 50);
    EXPECT_TRUE(rest().ok()) << rest().message;
  }
}

TEST_F(Resting, WithoutNoiseIsRestToo) {
  take(10, 0.0, 0.0);
  EXPECT_TRUE(rest().ok()) << rest().message;
}

// 0.2 mm a sample is a fifth of the noise of one: it shows in the averages.
TEST_F(Resting, ASlowDriftIsMotion) {
  take(100, 2e-4);
  EXPECT_EQ(rest().code, Code::kInvalidInput);
  EXPECT_NE(rest().message.find("not at rest: the length of cable 'cable3'"), std::string::npos) << rest().message;
}

TEST_F(Resting, ASwingThatEndsWhereItBeganIsMotion) {
  for (int k = 0; k < 100; ++k) {
    CableMeasurements measured;
    measured.lengths.assign(robot_.cables.size(), 9.0 + 5e-3 * std::sin(2.0 * M_PI * k / 25.0));
    measured.tensions.assign(robot_.cables.size(), 300.0);
    samples_.add(measured);
  }
  EXPECT_EQ(rest().code, Code::kInvalidInput);
}

TEST_F(Resting, MissingSamplesAreNamed) {
  EXPECT_NE(rest().message.find("cable 'cable0' has 0 samples of its length"), std::string::npos) << rest().message;
  CableMeasurements lengths_only;
  lengths_only.lengths.assign(robot_.cables.size(), 9.0);
  lengths_only.tensions.assign(robot_.cables.size(), std::nullopt);
  for (int k = 0; k < 10; ++k) samples_.add(lengths_only);
  EXPECT_TRUE(rest(false).ok());
  EXPECT_NE(rest(true).message.find("0 samples of its tension"), std::string::npos) << rest(true).message;
}

TEST_F(Resting, TensionsThatDriftCountOnlyWhereTheyAreUsed) {
  for (int k = 0; k < 100; ++k) {
    CableMeasurements measured;
    measured.lengths.assign(robot_.cables.size(), 9.0);
    measured.tensions.assign(robot_.cables.size(), 300.0 + k);
    samples_.add(measured);
  }
  EXPECT_TRUE(rest(false).ok());
  EXPECT_FALSE(rest(true).ok());
}

}  // namespace
}  // namespace cdpr_kinetostatics

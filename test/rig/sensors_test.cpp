// What the rig's sensors say of the truth: noise of the right size, bias, steps, drop-outs, every kind of fault, and
// the same numbers for the same seed.

#include "rig/sensors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {
namespace {

class Sensors : public testing::Test {
 protected:
  Sensors() : robot_(loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot) {
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      truth_.lengths.push_back(10.0 + 0.1 * static_cast<double>(i));
      truth_.tensions.push_back(400.0 + 10.0 * static_cast<double>(i));
    }
  }

  std::optional<sensor_msgs::JointState> measureOnce(const RigSensors& sensors, double time = 0.0) const {
    return RigMeasurements(robot_, sensors).measure(truth_, time);
  }

  static RigSensors withFault(RigFault::Kind kind, double value) {
    RigSensors sensors;
    RigFault fault;
    fault.kind = kind;
    fault.cable = 2;
    fault.value = value;
    fault.start = 1.0;
    fault.end = 2.0;
    sensors.faults.push_back(fault);
    return sensors;
  }

  const RobotDescription robot_;
  RigTruth truth_;
};

TEST_F(Sensors, TellTheTruthUnlessAskedOtherwise) {
  const auto message = measureOnce(RigSensors());
  ASSERT_TRUE(message);
  EXPECT_EQ(message->position, truth_.lengths);
  EXPECT_EQ(message->effort, truth_.tensions);
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) EXPECT_EQ(message->name[i], robot_.cables[i].name);

  RigSensors lengths_only;
  lengths_only.tensions = false;
  EXPECT_TRUE(measureOnce(lengths_only)->effort.empty());
}

// Of n draws, the mean is within 5 / sqrt(n) and the variance within 5 sqrt(2/n) of what they should be.
TEST_F(Sensors, NoiseIsNormalOfTheSizeAskedForAboutTheBias) {
  RigSensors sensors;
  sensors.length_noise = 1e-3;
  sensors.tension_noise = 5.0;
  sensors.length_bias = 2e-3;
  sensors.tension_bias = -3.0;
  RigMeasurements measurements(robot_, sensors);
  constexpr int kMessages = 4000;
  double n = 0.0;
  Eigen::Array2d sum = Eigen::Array2d::Zero();
  Eigen::Array2d squares = Eigen::Array2d::Zero();
  double product = 0.0;
  double beyond_two = 0.0;
  for (int k = 0; k < kMessages; ++k) {
    const auto message = measurements.measure(truth_, 0.0);
    for (std::size_t i = 0; i < truth_.lengths.size(); ++i) {
      const Eigen::Array2d draw(
          (message->position[i] - truth_.lengths[i] - sensors.length_bias) / sensors.length_noise,
          (message->effort[i] - truth_.tensions[i] - sensors.tension_bias) / sensors.tension_noise);
      n += 1.0;
      sum += draw;
      squares += draw.square();
      product += draw.prod();
      beyond_two += std::abs(draw(0)) > 2.0 ? 1.0 : 0.0;
    }
  }
  const Eigen::Array2d mean = sum / n;
  const Eigen::Array2d variance = squares / n - mean.square();
  EXPECT_LT(mean.abs().maxCoeff(), 5.0 / std::sqrt(n));
  EXPECT_LT((variance - 1.0).abs().maxCoeff(), 5.0 * std::sqrt(2.0 / n));
  EXPECT_LT(std::abs(product / n), 5.0 / std::sqrt(n))
      << "noises of lengths and tensions must not depend on each other";
  const double normal_share = std::erfc(2.0 / std::sqrt(2.0));
  EXPECT_NEAR(beyond_two / n, normal_share, 5.0 * std::sqrt(normal_share / n));
}

TEST_F(Sensors, StepsRoundToTheNearest) {
  RigSensors sensors;
  sensors.length_noise = 1e-3;
  sensors.length_resolution = 1e-4;
  sensors.tension_resolution = 8.0;
  const auto message = measureOnce(sensors);
  RigSensors fine = sensors;
  fine.length_resolution = 0.0;
  const auto unrounded = measureOnce(fine);
  for (std::size_t i = 0; i < truth_.lengths.size(); ++i) {
    EXPECT_NEAR(message->position[i] / 1e-4, std::round(message->position[i] / 1e-4), 1e-6);
    EXPECT_LE(std::abs(message->position[i] - unrounded->position[i]), 0.5e-4 * (1.0 + 1e-9));
    EXPECT_EQ(std::remainder(message->effort[i], 8.0), 0.0);
    EXPECT_LE(std::abs(message->effort[i] - truth_.tensions[i]), 4.0);
  }
}

TEST_F(Sensors, MessagesDropOutAsOftenAsAskedFor) {
  RigSensors sensors;
  sensors.dropout = 0.2;
  RigMeasurements measurements(robot_, sensors);
  constexpr int kMessages = 10000;
  int lost = 0;
  for (int k = 0; k < kMessages; ++k) lost += measurements.measure(truth_, 0.0) ? 0 : 1;
  EXPECT_NEAR(lost, 0.2 * kMessages, 5.0 * std::sqrt(0.2 * 0.8 * kMessages));
  sensors.dropout = 1.0;
  EXPECT_FALSE(measureOnce(sensors));
}

TEST_F(Sensors, SeedDecidesEverything) {
  RigSensors sensors;
  sensors.length_noise = 1e-3;
  sensors.tension_noise = 5.0;
  sensors.dropout = 0.3;
  RigSensors other_seed = sensors;
  other_seed.seed = 2;
  RigMeasurements first(robot_, sensors), again(robot_, sensors), other(robot_, other_seed);
  bool differs = false;
  for (int k = 0; k < 50; ++k) {
    const auto a = first.measure(truth_, 0.0), b = again.measure(truth_, 0.0), c = other.measure(truth_, 0.0);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      EXPECT_EQ(a->position, b->position);
      EXPECT_EQ(a->effort, b->effort);
    }
    differs |= a.has_value() != c.has_value() || (a && a->position != c->position);
  }
  EXPECT_TRUE(differs);
}

TEST_F(Sensors, FaultsLeaveTheNoiseOfOthersAsItWas) {
  RigSensors faulty = withFault(RigFault::Kind::kLengthOffset, 0.3);
  faulty.length_noise = 1e-3;
  RigSensors sound = faulty;
  sound.faults.clear();
  const auto with = measureOnce(faulty, 1.5), without = measureOnce(sound, 1.5);
  for (std::size_t i = 0; i < truth_.lengths.size(); ++i) {
    EXPECT_NEAR(with->position[i] - without->position[i], i == 2 ? 0.3 : 0.0, i == 2 ? 1e-12 : 0.0);
  }
}

TEST_F(Sensors, FaultsHoldFromTheirStartToTheirEnd) {
  struct Case {
    RigFault::Kind kind;
    double value, length, tension;
  };
  const double nan = std::nan("");
  const double length = truth_.lengths[2], tension = truth_.tensions[2];
  const Case cases[] = {
      {RigFault::Kind::kStuckTension, 777.0, length, 777.0},
      {RigFault::Kind::kTensionBias, 100.0, length, tension + 100.0},
      {RigFault::Kind::kLengthOffset, -0.25, length - 0.25, tension},
      {RigFault::Kind::kNoLength, 0.0, nan, tension},
      {RigFault::Kind::kNoTension, 0.0, length, nan},
  };
  const auto expect = [](double found, double expected) {
    if (std::isnan(expected)) {
      EXPECT_TRUE(std::isnan(found));
    } else {
      EXPECT_EQ(found, expected);
    }
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(static_cast<int>(one.kind));
    const RigSensors sensors = withFault(one.kind, one.value);
    for (const double time : {0.99, 1.0, 2.0, 2.01}) {
      const bool faulty = time >= 1.0 && time <= 2.0;
      const auto message = measureOnce(sensors, time);
      expect(message->position[2], faulty ? one.length : length);
      expect(message->effort[2], faulty ? one.tension : tension);
      expect(message->effort[3], truth_.tensions[3]);
    }
  }
}

TEST_F(Sensors, StuckCellStaysWhereItWas) {
  const RigSensors sensors = withFault(RigFault::Kind::kStuckTension, 0.0);
  RigMeasurements measurements(robot_, sensors);
  const double before = truth_.tensions[2];
  EXPECT_EQ(measurements.measure(truth_, 1.0)->effort[2], before);
  truth_.tensions[2] += 50.0;
  EXPECT_EQ(measurements.measure(truth_, 1.5)->effort[2], before);
  EXPECT_EQ(measurements.measure(truth_, 2.5)->effort[2], before + 50.0);
}

TEST_F(Sensors, TensionFaultsNeedNoTensions) {
  RigSensors sensors = withFault(RigFault::Kind::kStuckTension, 777.0);
  sensors.tensions = false;
  const auto message = measureOnce(sensors, 1.5);
  EXPECT_TRUE(message->effort.empty());
  EXPECT_EQ(message->position, truth_.lengths);
}

// The node that knows scale and offset gets the lengths back; faults are in metres.
TEST_F(Sensors, DrivesReportPositions) {
  RobotDescription robot = robot_;
  robot.cables[2].scale = -0.002;
  robot.cables[2].offset = 15.0;
  RigSensors sensors = withFault(RigFault::Kind::kLengthOffset, 0.3);
  const auto before = RigMeasurements(robot, sensors).measure(truth_, 0.0);
  const auto during = RigMeasurements(robot, sensors).measure(truth_, 1.5);
  ASSERT_TRUE(before && during);
  EXPECT_NEAR(robot.cables[2].lengthAt(before->position[2]), truth_.lengths[2], 1e-12);
  EXPECT_NEAR(robot.cables[2].lengthAt(during->position[2]), truth_.lengths[2] + 0.3, 1e-12);
  EXPECT_EQ(before->position[3], truth_.lengths[3]);
}

// Each drum's zero is drawn once, and leaves all other numbers as they were.
TEST_F(Sensors, UnknownZerosAreDrawnOnce) {
  RigSensors sensors;
  sensors.length_noise = 1e-3;
  RigSensors with_error = sensors;
  with_error.offset_error = 0.02;
  RigMeasurements known(robot_, sensors);
  RigMeasurements unknown(robot_, with_error);
  std::vector<double> errors;
  for (int k = 0; k < 5; ++k) {
    const auto right = known.measure(truth_, 0.1 * k);
    const auto wrong = unknown.measure(truth_, 0.1 * k);
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      const double error = wrong->position[i] - right->position[i];
      if (k == 0) errors.push_back(error);
      EXPECT_NEAR(error, errors[i], 1e-12);
    }
    EXPECT_EQ(right->effort, wrong->effort);
  }
  EXPECT_NE(errors[0], errors[1]);
  double squares = 0.0;
  for (const double error : errors) squares += error * error;
  EXPECT_GT(std::sqrt(squares / 8.0), 0.005);
  EXPECT_LT(std::sqrt(squares / 8.0), 0.05);
}

}  // namespace
}  // namespace cdpr_kinetostatics

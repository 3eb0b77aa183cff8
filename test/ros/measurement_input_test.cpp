// Every message on cable_states is either used or refused with a reason, and counted.

#include "ros/measurement_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "ros/measurement_queue.h"

namespace cdpr_kinetostatics {
namespace {

const ros::Time kStart(1000.0);

class Input : public testing::Test {
 protected:
  Input() : robot_(loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot), input_(robot_, 0.5) {}

  sensor_msgs::JointState message(double after_start = 0.0) const {
    sensor_msgs::JointState m;
    m.header.stamp = kStart + ros::Duration(after_start);
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      m.name.push_back(robot_.cables[i].name);
      m.position.push_back(10.0 + static_cast<double>(i));
      m.effort.push_back(400.0 + static_cast<double>(i));
    }
    return m;
  }

  std::optional<Measurement> check(const sensor_msgs::JointState& m) { return input_.check(m, m.header.stamp); }

  RobotDescription robot_;
  MeasurementInput input_;
};

TEST_F(Input, IsMatchedByName) {
  sensor_msgs::JointState m = message();
  std::reverse(m.name.begin(), m.name.end());
  const auto measurement = check(m);
  ASSERT_TRUE(measurement);
  EXPECT_FALSE(measurement->reset_first);
  EXPECT_EQ(*measurement->cables.lengths[0], 17.0);
  EXPECT_EQ(*measurement->cables.tensions[7], 400.0);
  EXPECT_EQ(input_.counts().accepted, 1u);
  EXPECT_TRUE(input_.lastProblem().empty());
}

TEST_F(Input, MayBeLengthsOnly) {
  sensor_msgs::JointState m = message();
  m.effort.clear();
  const auto measurement = check(m);
  ASSERT_TRUE(measurement);
  EXPECT_FALSE(measurement->cables.tensions[3]);
  EXPECT_EQ(input_.counts().missing_tensions, 0u);
}

TEST_F(Input, MayMissMeasurements) {
  sensor_msgs::JointState m = message();
  m.position[2] = std::nan("");
  m.effort[5] = std::nan("");
  m.effort[6] = std::numeric_limits<double>::infinity();
  m.position[1] = -1.0;
  m.effort[0] = -10.0;  // noise about zero
  m.name.pop_back();
  m.position.pop_back();
  m.effort.pop_back();
  const auto measurement = check(m);
  ASSERT_TRUE(measurement);
  for (const int i : {1, 2, 7}) EXPECT_FALSE(measurement->cables.lengths[i]);
  for (const int i : {5, 6, 7}) EXPECT_FALSE(measurement->cables.tensions[i]);
  EXPECT_EQ(*measurement->cables.tensions[0], -10.0);
  EXPECT_EQ(input_.counts().missing_lengths, 3u);
  EXPECT_EQ(input_.counts().missing_tensions, 3u);
  EXPECT_EQ(input_.counts().impossible, 2u);
}

TEST_F(Input, ZeroLengthsAreCalledZeroLengths) {
  sensor_msgs::JointState m = message();
  m.position.assign(m.position.size(), 0.0);
  ASSERT_TRUE(check(m));
  EXPECT_NE(input_.lastProblem().find("position[0] of cable 'cable0' is 0 m: expected"), std::string::npos)
      << input_.lastProblem();
  EXPECT_NE(input_.lastProblem().find("and 7 more like this"), std::string::npos) << input_.lastProblem();
  EXPECT_EQ(input_.counts().impossible, 8u);
  EXPECT_EQ(input_.counts().missing_lengths, 8u);
}

TEST_F(Input, WorstProblemIsTheOneThatIsTold) {
  sensor_msgs::JointState m = message(0.0);
  m.name[1] = "gripper";
  ASSERT_TRUE(check(m));
  EXPECT_NE(input_.lastProblem().find("no length of cable1"), std::string::npos) << input_.lastProblem();
  m = message(0.1);
  m.name[1] = "gripper";
  m.effort[3] = std::numeric_limits<double>::infinity();
  ASSERT_TRUE(check(m));
  EXPECT_EQ(input_.lastProblem().find("effort[3] of cable 'cable3' is inf"), 0u) << input_.lastProblem();
}

TEST_F(Input, WithoutATimeIsRefusedAndSaysWhy) {
  EXPECT_FALSE(input_.check(message(), ros::Time()));
  EXPECT_NE(input_.lastProblem().find("nothing has come on /clock"), std::string::npos) << input_.lastProblem();
  EXPECT_EQ(input_.counts().stale, 1u);
}

TEST_F(Input, MayHaveOtherNamesToo) {
  sensor_msgs::JointState m = message();
  m.name.push_back("gripper");
  m.position.push_back(0.1);
  m.effort.push_back(0.0);
  EXPECT_TRUE(check(m));
  EXPECT_EQ(input_.counts().unknown_names, 1u);
  EXPECT_NE(input_.lastProblem().find("gripper"), std::string::npos);
}

TEST_F(Input, OfTheWrongShapeIsRefused) {
  const std::vector<std::pair<std::function<void(sensor_msgs::JointState&)>, std::string>> cases = {
      {[](auto& m) { m.name.clear(); }, "name is empty"},
      {[](auto& m) { m.position.pop_back(); }, "position has 7"},
      {[](auto& m) { m.effort.pop_back(); }, "effort has 7"},
      {[](auto& m) { m.name[3] = m.name[0]; }, "'cable0' more than once"},
      {[](auto& m) { m.name.assign(8, "x"), m.name.resize(1), m.position.resize(1), m.effort.resize(1); }, "'x'"},
  };
  for (const auto& [spoil, words] : cases) {
    sensor_msgs::JointState m = message();
    spoil(m);
    EXPECT_FALSE(check(m));
    EXPECT_NE(input_.lastProblem().find(words), std::string::npos) << input_.lastProblem();
  }
  EXPECT_EQ(input_.counts().malformed, cases.size());
  EXPECT_EQ(input_.counts().refused(), input_.counts().received);
}

TEST_F(Input, OfTheWrongTimeIsRefused) {
  EXPECT_TRUE(check(message(1.0)));
  EXPECT_FALSE(check(message(1.0)));
  EXPECT_EQ(input_.counts().repeated, 1u);
  EXPECT_FALSE(input_.check(message(0.9), kStart + ros::Duration(1.1)));
  EXPECT_EQ(input_.counts().reordered, 1u);
  EXPECT_FALSE(input_.check(message(1.2), kStart + ros::Duration(1.8)));
  EXPECT_FALSE(input_.check(message(2.5), kStart + ros::Duration(1.9)));
  sensor_msgs::JointState unstamped = message();
  unstamped.header.stamp = ros::Time();
  EXPECT_FALSE(input_.check(unstamped, kStart + ros::Duration(2.0)));
  EXPECT_EQ(input_.counts().stale, 3u);
  EXPECT_TRUE(input_.check(message(2.0), kStart + ros::Duration(2.1)));
  EXPECT_EQ(input_.counts().time_jumps, 0u);
}

TEST_F(Input, OfAnyStampAtAnyTimeIsRefusedOrUsed) {
  constexpr std::uint32_t kMax = std::numeric_limits<std::uint32_t>::max();
  const std::vector<ros::Time> times = {ros::Time(0, 1),    kStart,        ros::Time(2147483647, 0),
                                        ros::Time(kMax, 0), ros::TIME_MIN, ros::TIME_MAX};
  std::uint64_t stale = 0;
  for (const ros::Time& now : times) {
    for (const ros::Time& stamp : times) {
      sensor_msgs::JointState m = message();
      m.header.stamp = stamp;
      const bool near = std::abs(stamp.toSec() - now.toSec()) <= 0.5;
      if (!near) ++stale;
      const auto measurement = input_.check(m, now);
      EXPECT_FALSE(measurement && !near) << stamp << " at " << now;
      EXPECT_EQ(input_.counts().stale, stale) << stamp << " at " << now;
    }
  }
  EXPECT_EQ(input_.counts().accepted + input_.counts().refused(), times.size() * times.size());
  EXPECT_GT(input_.counts().accepted, 0u);
  sensor_msgs::JointState unnormalised = message();
  unnormalised.header.stamp.sec = unnormalised.header.stamp.nsec = kMax;  // as a message may carry it
  EXPECT_FALSE(input_.check(unnormalised, kStart));
  EXPECT_NE(input_.lastProblem().find("in the future"), std::string::npos) << input_.lastProblem();
}

TEST_F(Input, ThatGoesBackByACenturyStartsAnew) {
  sensor_msgs::JointState late = message();
  late.header.stamp = ros::Time(4000000000.0);
  EXPECT_TRUE(check(late));
  const auto after_jump = check(message(1.0));
  ASSERT_TRUE(after_jump);
  EXPECT_TRUE(after_jump->reset_first);
}

TEST_F(Input, ThatGoesBackInTimeStartsAnew) {
  EXPECT_TRUE(check(message(100.0)));
  const auto after_jump = check(message(1.0));
  ASSERT_TRUE(after_jump);
  EXPECT_TRUE(after_jump->reset_first);
  const auto next = check(message(1.1));
  ASSERT_TRUE(next);
  EXPECT_FALSE(next->reset_first);
  // The clock goes back by less than max_age; the first message after that is still from before.
  EXPECT_FALSE(input_.check(message(0.2), kStart + ros::Duration(0.8)));
  const auto after_small_jump = check(message(0.9));
  ASSERT_TRUE(after_small_jump);
  EXPECT_TRUE(after_small_jump->reset_first);
  EXPECT_EQ(input_.counts().time_jumps, 2u);
}

TEST_F(Input, MayRepeatAfterReset) {
  EXPECT_TRUE(check(message(1.0)));
  input_.reset();
  const auto again = check(message(1.0));
  ASSERT_TRUE(again);
  EXPECT_FALSE(again->reset_first);
  EXPECT_EQ(input_.counts().received, 2u);
}

TEST(MeasurementQueue, OldestGiveWayAndAreCounted) {
  MeasurementQueue queue(2);
  for (std::uint32_t k = 0; k < 5; ++k) {
    Measurement m;
    m.header.seq = k;
    m.reset_first = k == 1;
    queue.push(m);
  }
  EXPECT_EQ(queue.superseded(), 3u);
  const auto first = queue.pop();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->header.seq, 3u);
  EXPECT_TRUE(first->reset_first) << "a reset must not get lost with its message";
  EXPECT_FALSE(queue.pop()->reset_first);
  queue.close();
  EXPECT_FALSE(queue.pop());
}

// Positions are what drives count; a length that cannot be is one after scale and offset.
TEST_F(Input, PositionsBecomeLengthsByScaleAndOffset) {
  robot_.cables[2].scale = -0.002;
  robot_.cables[2].offset = 15.0;
  MeasurementInput input(robot_, 0.5);
  sensor_msgs::JointState m = message();
  m.position[2] = 1500.0;
  const auto measurement = input.check(m, m.header.stamp);
  ASSERT_TRUE(measurement);
  EXPECT_DOUBLE_EQ(*measurement->cables.lengths[2], 12.0);
  EXPECT_EQ(*measurement->cables.lengths[3], 13.0);
  m = message(1.0);
  m.position[2] = 7500.0;
  EXPECT_FALSE(input.check(m, m.header.stamp)->cables.lengths[2]) << "0 m";
  EXPECT_EQ(input.counts().impossible, 1u);
}

TEST_F(Input, OffsetsThatAreSetHoldFromThenOn) {
  std::vector<double> offsets = input_.offsets();
  EXPECT_EQ(offsets, std::vector<double>(robot_.cables.size(), 0.0));
  offsets[4] = 0.25;
  input_.setOffsets(offsets);
  EXPECT_DOUBLE_EQ(*check(message())->cables.lengths[4], 14.25);
}

}  // namespace
}  // namespace cdpr_kinetostatics

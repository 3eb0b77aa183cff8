#include "ros/request_checks.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {
namespace {

NodeParameters parameters() {
  NodeParameters parameters;
  parameters.robot = loadRobotFile(ROBOT_DIR "/scampi.yaml").robot;
  parameters.model = Model::kCatenary;
  parameters.accuracy = 2e-3;
  parameters.tolerance = 3e-7;
  parameters.timeout = 0.4;
  return parameters;
}

const RobotDescription& robot() {
  static const RobotDescription robot = parameters().robot;
  return robot;
}

// What the check throws; an error of code UNSET if it does not.
RequestError refusalOf(const std::function<void()>& check) {
  try {
    check();
  } catch (const RequestError& error) {
    return error;
  }
  return RequestError("", Code::kUnset);
}

void expectRefused(const std::function<void()>& check, Code code, const std::string& words) {
  const RequestError refusal = refusalOf(check);
  EXPECT_EQ(refusal.code(), code);
  EXPECT_NE(std::string(refusal.what()).find(words), std::string::npos) << refusal.what();
}

TEST(RequestChecks, RefusalsOfTheCoreKeepTheirCode) {
  EXPECT_NO_THROW(require({Code::kConverged, ""}));
  expectRefused(
      [] {
        require({Code::kInfeasible, "too short"}, ", or none");
      },
      Code::kInfeasible, "too short, or none");
}

TEST(RequestChecks, LengthsWithoutNamesStayInOrder) {
  EXPECT_EQ(orderedLengths({4.0, 3.0, 2.0, 1.0}, {}, robot()), (std::vector<double>{4.0, 3.0, 2.0, 1.0}));
}

TEST(RequestChecks, LengthsAreOrderedByName) {
  ASSERT_EQ(robot().cables.size(), 4u);
  const auto name = [](std::size_t i) { return robot().cables[i].name; };
  const std::vector<std::string> names = {name(2), name(0), name(3), name(1)};
  EXPECT_EQ(orderedLengths({1.0, 2.0, 3.0, 4.0}, names, robot()), (std::vector<double>{2.0, 4.0, 1.0, 3.0}));
  expectRefused(
      [&] {
        orderedLengths({1.0, -2.0, 3.0, 4.0}, names, robot());
      },
      Code::kInvalidInput, "lengths[1] of cable '" + name(0) + "' is -2 m");
  expectRefused(
      [&] {
        orderedLengths({1.0, 2.0, 3.0}, {name(2), name(0), name(3)}, robot());
      },
      Code::kInvalidInput, "lengths has 3 entries: expected 4");
  expectRefused(
      [&] {
        orderedLengths({1.0, 2.0}, {name(2), name(2)}, robot());
      },
      Code::kInvalidInput, "cable_names[1] is '" + name(2) + "' once more");
  expectRefused([&] { orderedLengths({1.0}, {"rope"}, robot()); }, Code::kUnknownCable, "cable_names[0] is 'rope'");
}

TEST(RequestChecks, CablesAreFoundByName) {
  EXPECT_EQ(&findCable(robot().cables[1].name, robot()), &robot().cables[1]);
  expectRefused([] { findCable("rope", robot()); }, Code::kUnknownCable, robot().cables[3].name);
}

TEST(RequestChecks, QuaternionsAreNormalisedIfNearlyUnit) {
  geometry_msgs::Pose pose;
  pose.position.z = 1.5;
  pose.orientation.z = 0.6 * 1.0009;
  pose.orientation.w = 0.8 * 1.0009;
  const Pose checked = checkedPose("pose", pose);
  EXPECT_NEAR(checked.orientation.z(), 0.6, 1e-15);
  EXPECT_NEAR(checked.orientation.w(), 0.8, 1e-15);
  EXPECT_EQ(checked.position.z(), 1.5);
  pose.orientation.w = 0.81;
  expectRefused([&] { checkedPose("seed", pose); }, Code::kInvalidInput, "seed.orientation");
  pose.orientation = geometry_msgs::Quaternion();
  expectRefused([&] { checkedPose("seed", pose); }, Code::kInvalidInput, "of norm 0");
}

TEST(RequestChecks, ZerosStandForTheNodesParameters) {
  const RobotSolverOptions checked = checkedOptions(SolverOptions(), 0, parameters());
  EXPECT_EQ(checked.model, Model::kCatenary);
  EXPECT_EQ(checked.accuracy, 2e-3);
  EXPECT_EQ(checked.tolerance, 3e-7);
  EXPECT_EQ(checked.timeout.count(), 0.4);
  EXPECT_EQ(checked.profile_points, 0);
}

TEST(RequestChecks, OptionsAskedForCount) {
  SolverOptions options;
  options.model = SolverOptions::BENDING;
  options.accuracy = 1e-5;
  options.tolerance = 1e-9;
  options.timeout = ros::Duration(0.25);
  const RobotSolverOptions checked = checkedOptions(options, 7, parameters());
  EXPECT_EQ(checked.model, Model::kBending);
  EXPECT_EQ(checked.accuracy, 1e-5);
  EXPECT_EQ(checked.tolerance, 1e-9);
  EXPECT_EQ(checked.timeout.count(), 0.25);
  EXPECT_EQ(checked.profile_points, 7);
}

TEST(RequestChecks, RefusedOptionsSayWhatZeroMeans) {
  SolverOptions options;
  options.tolerance = 0.5;
  expectRefused([&] { checkedOptions(options, 0, parameters()); }, Code::kInvalidInput, "or 0 for the node's 3e-07");
  options = SolverOptions();
  options.accuracy = -1.0;
  expectRefused([&] { checkedOptions(options, 0, parameters()); }, Code::kInvalidInput, "or 0 for the node's 0.002");
  expectRefused([&] { checkedOptions(SolverOptions(), kMostMessagePoints + 1, parameters()); }, Code::kInvalidInput,
                "profile_points is 10001");
}

}  // namespace
}  // namespace cdpr_kinetostatics

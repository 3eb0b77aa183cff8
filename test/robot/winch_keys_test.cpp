// Pulleys and winches in a robot file: defaults for all cables, overridden key by key, refused in words.
#include "robot/winch_keys.h"

#include <gtest/gtest.h>

#include "good_robot.h"

namespace cdpr_kinetostatics {
namespace {

RobotDescription parsed(const YAML::Node& node) { return parseRobot(node).robot; }

TEST(WinchKeys, WithoutThemACableBeginsAtAnEyeletAndReportsMetres) {
  for (const CableDescription& cable : parsed(goodRobot()).cables) {
    EXPECT_EQ(cable.properties.pulley.radius, 0.0);
    EXPECT_EQ(cable.properties.dead_length, 0.0);
    EXPECT_EQ(cable.scale, 1.0);
    EXPECT_EQ(cable.offset, 0.0);
  }
}

TEST(WinchKeys, APointOverridesTheDefaultsKeyByKey) {
  YAML::Node node = goodRobot();
  node["pulley"] = YAML::Load("{radius: 0.05, rope_from: above}");
  node["winch"] = YAML::Load("{dead_length: 8, scale: -0.002, offset: 1.5}");
  node["points"][1]["pulley"] = YAML::Load("{rope_from: below}");
  node["points"][1]["winch"] = YAML::Load("{offset: 2.5}");
  node["points"][2]["pulley"] = YAML::Load("{radius: 0}");
  const RobotDescription robot = parsed(node);
  EXPECT_EQ(robot.cables[0].properties.pulley.radius, 0.05);
  EXPECT_EQ(robot.cables[0].properties.pulley.rope_from, RopeFrom::kAbove);
  EXPECT_EQ(robot.cables[0].properties.dead_length, 8.0);
  EXPECT_EQ(robot.cables[0].scale, -0.002);
  EXPECT_EQ(robot.cables[0].offset, 1.5);
  EXPECT_EQ(robot.cables[1].properties.pulley.radius, 0.05);
  EXPECT_EQ(robot.cables[1].properties.pulley.rope_from, RopeFrom::kBelow);
  EXPECT_EQ(robot.cables[1].scale, -0.002);
  EXPECT_EQ(robot.cables[1].offset, 2.5);
  EXPECT_EQ(robot.cables[2].properties.pulley.radius, 0.0) << "an eyelet";
}

TEST(WinchKeys, NumbersAreReadAsEverywhereElse) {
  YAML::Node node = goodRobot();
  node["winch"] = YAML::Load("{scale: 1e-3, offset: 010, dead_length: 1_0}");
  const RobotDescription robot = parsed(node);
  EXPECT_EQ(robot.cables[0].scale, 1e-3);
  EXPECT_EQ(robot.cables[0].offset, 8.0) << "YAML's octal";
  EXPECT_EQ(robot.cables[0].properties.dead_length, 10.0);
}

TEST(WinchKeys, AVerticalAxisIsWhatIsDescribed) {
  YAML::Node node = goodRobot();
  node["pulley"] = YAML::Load("{radius: 0.05, axis: [0, 0, 1]}");
  EXPECT_EQ(complaint(node), "");
}

TEST(WinchKeys, UnknownKeysAreNamedInAWarning) {
  YAML::Node node = goodRobot();
  node["pulley"] = YAML::Load("{radius: 0.05, width: 0.02}");
  node["points"][1]["winch"] = YAML::Load("{drum: 0.1}");
  const LoadedRobot loaded = parseRobot(node);
  ASSERT_EQ(loaded.warnings.size(), 2u);
  EXPECT_EQ(loaded.warnings[0], "pulley.width is ignored: no such key");
  EXPECT_EQ(loaded.warnings[1], "points[1].winch.drum is ignored: no such key");
}

TEST(WinchKeys, WhatCannotBeIsRefusedWithItsKeyAndValue) {
  const struct {
    const char* map;
    const char* value;
    const char* complaint;
  } kMistakes[] = {
      {"pulley", "0.05", "pulley = 0.05: expected a map of keys"},
      {"pulley", "{radius: -0.05}", "pulley.radius = -0.05: expected a number, finite and >= 0 [m]"},
      {"pulley", "{radius: wide}", "pulley.radius = wide: expected a number"},
      {"pulley", "{rope_from: left}", "pulley.rope_from = left: expected below"},
      {"pulley", "{rope_from: 1.5}", "pulley.rope_from = 1.5: expected"},
      {"pulley", "{axis: [0.1, 0, 1]}", "pulley.axis = [0.1, 0, 1]: expected [0, 0, 1] or no such key: only pulleys"},
      {"pulley", "{swivel_axis: x}", "pulley.swivel_axis = x: expected [0, 0, 1] or no such key"},
      {"winch", "{scale: 0}", "winch.scale = 0: expected a number that is not 0"},
      {"winch", "{scale: .nan}", "winch.scale = .nan: expected a number, finite"},
      {"winch", "{offset: .inf}", "winch.offset = .inf: expected a number, finite [m]"},
      {"winch", "{dead_length: -1}", "winch.dead_length = -1: expected a number, finite and >= 0 [m]"},
  };
  for (const auto& mistake : kMistakes) {
    YAML::Node node = goodRobot();
    node[mistake.map] = YAML::Load(mistake.value);
    const std::string text = complaint(node);
    EXPECT_EQ(text.substr(0, std::string(mistake.complaint).size()), mistake.complaint) << text;
    EXPECT_TRUE(contains(text, "expected")) << text;
  }
}

TEST(WinchKeys, LimitsOfRobotsHoldForFilesToo) {
  YAML::Node node = goodRobot();
  node["winch"] = YAML::Load("{scale: 1.0e-15}");
  EXPECT_TRUE(contains(complaint(node), "cable 'cable0': the magnitude of scale is")) << complaint(node);
  node["winch"] = YAML::Load("{dead_length: 1.0e+9}");
  EXPECT_TRUE(contains(complaint(node), "dead_length")) << complaint(node);
}

TEST(WinchKeys, AHomeWithinAPulleyIsRefused) {
  YAML::Node node = goodRobot();
  node["points"][0]["pulley"] = YAML::Load("{radius: 2.2}");
  EXPECT_TRUE(contains(complaint(node), "cable 'cable0': the end of the cable lies within its guide pulley"))
      << complaint(node);
}

TEST(WinchKeys, PositionAndLengthAreInverse) {
  CableDescription cable;
  cable.scale = -0.002;
  cable.offset = 1.5;
  EXPECT_DOUBLE_EQ(cable.lengthAt(-500.0), 2.5);
  EXPECT_DOUBLE_EQ(cable.positionAt(2.5), -500.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

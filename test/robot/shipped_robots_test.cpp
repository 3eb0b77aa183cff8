// The robots in config/robots load, make sense and agree with the reference values.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <string>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kPi = 3.14159265358979323846;

LoadedRobot shipped(const std::string& name) { return loadRobotFile(std::string(ROBOT_DIR) + "/" + name + ".yaml"); }

class ShippedRobot : public testing::TestWithParam<std::string> {};

TEST_P(ShippedRobot, LoadsWithoutWarningAndMakesSense) {
  const LoadedRobot loaded = shipped(GetParam());
  EXPECT_TRUE(loaded.warnings.empty());
  const RobotDescription& robot = loaded.robot;
  EXPECT_EQ(robot.name, GetParam());
  double highest = -1e9;
  for (const CableDescription& cable : robot.cables) {
    highest = std::max(highest, cable.anchor.z());
    EXPECT_GT(cable.tension_min, 0.0);
    EXPECT_GT(cable.tension_max * static_cast<double>(robot.cables.size()), robot.weight());
    const double chord = (robot.home.transform(cable.attachment) - cable.anchor).norm();
    EXPECT_LT(cable.properties.weight * chord, cable.tension_max);
    EXPECT_GT(cable.properties.bending_stiffness, 0.0);
  }
  EXPECT_LT(robot.home.position.z(), highest);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedRobot,
                         testing::Values("cogiro", "ipanema3", "fast", "caroca", "desktop_music_wire", "scampi",
                                         "paper_point_mass"));

void expectGolden(const RobotDescription& robot, const std::string& golden_name) {
  for (const YAML::Node& golden : YAML::LoadFile(std::string(TEST_DATA_DIR) + "/robots.json")) {
    if (golden["name"].as<std::string>() != golden_name) continue;
    ASSERT_EQ(robot.cables.size(), golden["A"].size());
    EXPECT_EQ(robot.gravity, golden["g"].as<double>());
    EXPECT_EQ(robot.mass, golden["mass"].as<double>());
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(robot.com[axis], golden["com"][axis].as<double>());
    for (std::size_t i = 0; i < robot.cables.size(); ++i) {
      const CableDescription& cable = robot.cables[i];
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(cable.anchor[axis], golden["A"][i][axis].as<double>());
        EXPECT_EQ(cable.attachment[axis], golden["b"][i][axis].as<double>());
      }
      EXPECT_DOUBLE_EQ(cable.properties.axial_stiffness, golden["EA"].as<double>());
      EXPECT_DOUBLE_EQ(cable.properties.bending_stiffness, golden["EI"].as<double>());
      EXPECT_DOUBLE_EQ(cable.properties.weight, golden["rho"].as<double>() * golden["g"].as<double>());
    }
    return;
  }
  FAIL() << golden_name << " is not in robots.json";
}

TEST(ShippedRobots, AgreeWithReference) {
  expectGolden(shipped("cogiro").robot, "cogiro_public");
  expectGolden(shipped("desktop_music_wire").robot, "acrobot_music_wire_public");
}

TEST(ShippedRobots, PaperPointMass) {
  const RobotDescription robot = shipped("paper_point_mass").robot;
  EXPECT_EQ(robot.freedoms(), 3);
  EXPECT_NEAR(robot.weight(), 10e3, 1e-9);
  ASSERT_EQ(robot.cables.size(), 2u);
  EXPECT_EQ(robot.cables[1].anchor, Eigen::Vector3d(10, 0, 2));
  EXPECT_NEAR(robot.cables[0].properties.axial_stiffness, 170e9 * kPi * 1e-4, 1e-3);
  EXPECT_NEAR(robot.cables[0].properties.bending_stiffness, 170e9 * kPi * 1e-8 / 4, 1e-8);
  EXPECT_NEAR(robot.cables[0].properties.weight, 8050 * kPi * 1e-4 * 9.81, 1e-10);
}

}  // namespace
}  // namespace cdpr_kinetostatics

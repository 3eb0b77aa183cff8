// Reading robot descriptions: keys, defaults, overrides, sections, files of oKermorgant/cdpr.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "good_robot.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(RobotDescription, ReadsEveryKey) {
  const LoadedRobot loaded = parseRobot(goodRobot());
  const RobotDescription& robot = loaded.robot;
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_EQ(robot.name, "tester");
  EXPECT_EQ(robot.gravity, 10.0);
  EXPECT_EQ(robot.type, PlatformType::kRigidBody);
  EXPECT_EQ(robot.freedoms(), 6);
  EXPECT_EQ(robot.mass, 5.0);
  EXPECT_EQ(robot.weight(), 50.0);
  EXPECT_EQ(robot.com, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(robot.home.position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(robot.size, Eigen::Vector3d(0.5, 0.6, 0.7));
  ASSERT_EQ(robot.cables.size(), 3u);
  EXPECT_EQ(robot.cables[0].name, "cable0");
  EXPECT_EQ(robot.cables[1].name, "east");
  EXPECT_EQ(robot.cables[2].name, "cable2");
  EXPECT_EQ(robot.cables[1].anchor, Eigen::Vector3d(4, 0, 5));
  EXPECT_EQ(robot.cables[1].attachment, Eigen::Vector3d(-0.1, 0, 0));
  for (const CableDescription& cable : robot.cables) {
    EXPECT_EQ(cable.properties.axial_stiffness, 2.87e5);
    EXPECT_EQ(cable.properties.bending_stiffness, 0.44);
    EXPECT_DOUBLE_EQ(cable.properties.weight, 0.064 * 10.0);
    EXPECT_EQ(cable.tension_min, 20.0);
    EXPECT_EQ(cable.tension_max, 5000.0);
  }
  EXPECT_DOUBLE_EQ(robot.span(), std::sqrt(32.0));
  EXPECT_DOUBLE_EQ(robot.platformRadius(), 0.1);
}

TEST(RobotDescription, DefaultsOfWhatMayBeLeftOut) {
  YAML::Node node = goodRobot();
  node.remove("name");
  node.remove("gravity");
  for (const char* key : {"type", "com", "size"}) node["platform"].remove(key);
  node["platform"]["position"].remove("rpy");
  node["cable"].remove("tension_min");
  const RobotDescription robot = parseRobot(node).robot;
  EXPECT_EQ(robot.name, "robot");
  EXPECT_EQ(robot.gravity, 9.81);
  EXPECT_EQ(robot.type, PlatformType::kRigidBody);
  EXPECT_EQ(robot.com, Eigen::Vector3d::Zero().eval());
  EXPECT_EQ(robot.size, Eigen::Vector3d::Ones().eval());
  EXPECT_TRUE(robot.home.orientation.isApprox(Eigen::Quaterniond::Identity()));
  EXPECT_EQ(robot.cables[0].tension_min, 0.0);
}

TEST(RobotDescription, RollPitchYawTurnsAboutFixedAxes) {
  YAML::Node node = goodRobot();
  node["platform"]["position"]["rpy"] = std::vector<double>{kPi / 2, 0, kPi / 2};
  const RobotDescription robot = parseRobot(node).robot;
  // Roll takes y to z, yaw leaves z; roll leaves x, yaw takes x to y.
  EXPECT_TRUE((robot.home.orientation * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_TRUE((robot.home.orientation * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
}

TEST(RobotDescription, PointMassNeedsNoAttachments) {
  YAML::Node node = goodRobot();
  node["platform"]["type"] = "point_mass";
  node["platform"].remove("com");
  node["points"][0].remove("platform");
  node["points"][1]["platform"] = std::vector<double>{0, 0, 0};
  node["points"][2]["platform"] = std::vector<double>{0, 0, 0};
  const RobotDescription robot = parseRobot(node).robot;
  EXPECT_EQ(robot.freedoms(), 3);
  EXPECT_EQ(robot.platformRadius(), 0.0);
}

TEST(RobotDescription, PointOverridesCableKeyByKey) {
  YAML::Node node = goodRobot();
  node["points"][1]["cable"]["bending_stiffness"] = 0;
  node["points"][1]["cable"]["tension_max"] = 100;
  const RobotDescription robot = parseRobot(node).robot;
  EXPECT_EQ(robot.cables[1].properties.bending_stiffness, 0.0);
  EXPECT_EQ(robot.cables[1].properties.axial_stiffness, 2.87e5);
  EXPECT_EQ(robot.cables[1].tension_max, 100.0);
  EXPECT_EQ(robot.cables[0].properties.bending_stiffness, 0.44);
}

TEST(RobotDescription, NumbersMayArriveAsText) {
  YAML::Node node = goodRobot();
  node["platform"]["mass"] = std::string("7.5");
  node["cable"]["axial_stiffness"] = std::string("2e5");  // ROS' YAML reader takes 2e5, without a sign, for text
  const RobotDescription robot = parseRobot(node).robot;
  EXPECT_EQ(robot.mass, 7.5);
  EXPECT_EQ(robot.cables[0].properties.axial_stiffness, 2e5);
}

class Section : public testing::Test {
 protected:
  Section() {
    for (const char* key : {"axial_stiffness", "bending_stiffness", "linear_density"}) node_["cable"].remove(key);
    node_["cable"]["radius"] = 0.01;
    node_["cable"]["youngs_modulus"] = 2e11;
    node_["cable"]["density"] = 7850;
  }
  CableProperties properties() const { return parseRobot(node_).robot.cables.at(0).properties; }

  YAML::Node node_ = goodRobot();
};

TEST_F(Section, SolidRoundSectionGivesAllThree) {
  EXPECT_NEAR(properties().axial_stiffness, 2e11 * kPi * 1e-4, 1e-4);
  EXPECT_NEAR(properties().bending_stiffness, 2e11 * kPi * 1e-8 / 4, 1e-9);
  EXPECT_NEAR(properties().weight, 7850 * kPi * 1e-4 * 10.0, 1e-11);
}

TEST_F(Section, DiameterMayReplaceRadius) {
  const CableProperties by_radius = properties();
  node_["cable"].remove("radius");
  node_["cable"]["diameter"] = 0.02;
  EXPECT_DOUBLE_EQ(properties().axial_stiffness, by_radius.axial_stiffness);
  EXPECT_DOUBLE_EQ(properties().bending_stiffness, by_radius.bending_stiffness);
}

TEST_F(Section, FillFactorScalesAreaAndMassOnly) {
  const CableProperties solid = properties();
  node_["cable"]["fill_factor"] = 0.5;
  EXPECT_DOUBLE_EQ(properties().axial_stiffness, 0.5 * solid.axial_stiffness);
  EXPECT_DOUBLE_EQ(properties().weight, 0.5 * solid.weight);
  EXPECT_DOUBLE_EQ(properties().bending_stiffness, solid.bending_stiffness);
}

TEST_F(Section, QuantityGivenTwiceMayAgree) {
  node_["cable"]["axial_stiffness"] = 62831853.0;  // 2e11 pi 1e-4, rounded
  node_["cable"]["diameter"] = 0.02;
  EXPECT_EQ(properties().axial_stiffness, 62831853.0);
}

TEST_F(Section, QuantitiesThatDisagreeAreAnError) {
  node_["cable"]["axial_stiffness"] = 6.3e7;
  EXPECT_EQ(complaint(node_),
            "cable.axial_stiffness = 63000000: expected agreement with 62831853.1 from cable.radius, "
            "cable.youngs_modulus, or only one of them");
  node_["cable"].remove("axial_stiffness");
  node_["points"][2]["cable"]["diameter"] = 0.03;
  EXPECT_TRUE(contains(complaint(node_),
                       "cable.radius = 0.01: expected agreement with 0.015 from "
                       "points[2].cable.diameter/2"));
}

TEST_F(Section, PartOfASectionBesideGivenQuantities) {
  node_["cable"].remove("density");
  node_["cable"]["linear_density"] = 2.0;
  EXPECT_DOUBLE_EQ(properties().weight, 20.0);
  EXPECT_NEAR(properties().axial_stiffness, 2e11 * kPi * 1e-4, 1e-4);
}

TEST_F(Section, OverriddenRadiusGivesThatCableItsOwnSection) {
  node_["points"][1]["cable"]["radius"] = 0.02;
  const RobotDescription robot = parseRobot(node_).robot;
  EXPECT_DOUBLE_EQ(robot.cables[1].properties.axial_stiffness, 4 * robot.cables[0].properties.axial_stiffness);
  EXPECT_DOUBLE_EQ(robot.cables[1].properties.bending_stiffness, 16 * robot.cables[0].properties.bending_stiffness);
}

TEST_F(Section, ModulusWithoutRadiusIsAnError) {
  node_["cable"].remove("radius");
  EXPECT_TRUE(contains(complaint(node_), "cable.youngs_modulus = 2e+11: expected radius or diameter beside it"));
}

TEST(RobotDescription, UnknownKeysAreNamedInWarnings) {
  YAML::Node node = goodRobot();
  node["platfrom"] = 1;
  node["platform"]["weight"] = 1;
  node["platform"]["position"]["quaternion"] = 1;
  node["cable"]["colour"] = "red";
  node["points"][1]["cable"]["stiffness"] = 3;
  node["points"][2]["drum"] = 0.1;
  const std::vector<std::string> warnings = parseRobot(node).warnings;
  ASSERT_EQ(warnings.size(), 6u);
  for (const char* path : {"platfrom", "platform.weight", "platform.position.quaternion", "cable.colour",
                           "points[1].cable.stiffness", "points[2].drum"}) {
    const std::string expected = std::string(path) + " is ignored: no such key";
    EXPECT_NE(std::find(warnings.begin(), warnings.end(), expected), warnings.end()) << expected;
  }
}

// A file as oKermorgant/cdpr writes it, for its cube robot.
const char* const kGazeboRobot = R"(
cable: {mass: 0.001, radius: 0.005}
frame: {color: Grey, lower: [-2, -2, 0], upper: [2, 2, 4], radius: 0.02, type: box}
joints:
  actuated: {damping: 1, effort: 100, min: 5, velocity: 10}
  passive: {damping: 0.01, effort: 100, velocity: 10}
platform:
  color: Yellow
  inertia: [1, 1, 1, 0, 0, 0]
  mass: 1
  position: {rpy: [0, 0, 0], xyz: [0, 0, 2]}
  size: [0.4, 0.4, 0.4]
  type: box
  visual: box
points:
- {frame: [-2.0, -2.0, 4.0], platform: [-0.2, -0.2, 0.0]}
- {frame: [-2.0, 2.0, 4.0], platform: [-0.2, 0.2, 0.0]}
- {frame: [2.0, 2.0, 4.0], platform: [0.2, 0.2, 0.0]}
- {frame: [2.0, -2.0, 4.0], platform: [0.2, -0.2, 0.0]}
sim_cables: true
)";

TEST(GazeboRobot, LoadsOnceCablePropertiesAreAdded) {
  YAML::Node node = YAML::Load(kGazeboRobot);
  EXPECT_TRUE(contains(complaint(node), "points[0].cable.axial_stiffness is missing")) << complaint(node);

  node["cable"]["youngs_modulus"] = 1e11;
  node["cable"]["density"] = 7850;
  const LoadedRobot loaded = parseRobot(node);
  const RobotDescription& robot = loaded.robot;
  EXPECT_EQ(robot.type, PlatformType::kRigidBody);
  ASSERT_EQ(robot.cables.size(), 4u);
  EXPECT_EQ(robot.cables[3].tension_min, 5.0);
  EXPECT_EQ(robot.cables[3].tension_max, 100.0);
  EXPECT_NEAR(robot.cables[3].properties.axial_stiffness, 1e11 * kPi * 25e-6, 1e-3);

  ASSERT_EQ(loaded.warnings.size(), 2u);
  EXPECT_EQ(loaded.warnings[0], "cable.mass is ignored: it is the mass of a simulated link; give linear_density");
  for (const char* path : {"frame", "sim_cables", "joints.passive", "joints.actuated.velocity", "platform.inertia"}) {
    EXPECT_TRUE(contains(loaded.warnings[1], path)) << loaded.warnings[1];
  }
}

TEST(GazeboRobot, LimitsGivenTwiceMustAgree) {
  YAML::Node node = goodRobot();
  node["joints"]["actuated"]["effort"] = 5000;
  EXPECT_EQ(complaint(node), "");
  node["joints"]["actuated"]["effort"] = 4000;
  EXPECT_TRUE(contains(complaint(node),
                       "cable.tension_max = 5000: expected agreement with 4000 from "
                       "joints.actuated.effort"));
}

TEST(GazeboRobot, PointOverridesLimitsOfJoints) {
  YAML::Node node = goodRobot();
  node["cable"].remove("tension_max");
  node["joints"]["actuated"]["effort"] = 4000;
  node["points"][1]["cable"]["tension_max"] = 300;
  const RobotDescription robot = parseRobot(node).robot;
  EXPECT_EQ(robot.cables[0].tension_max, 4000.0);
  EXPECT_EQ(robot.cables[1].tension_max, 300.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Every wrong value in a robot description is refused with its key, its value and what was expected.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <ostream>
#include <stdexcept>
#include <string>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "good_robot.h"

namespace cdpr_kinetostatics {
namespace {

// One wrong value each: where, what, and the start of the complaint.
struct Mistake {
  std::string path;   // keys separated by '/', list indices as numbers
  std::string value;  // YAML; empty: the key is removed
  std::string complaint;
};

std::ostream& operator<<(std::ostream& out, const Mistake& mistake) {
  return out << mistake.path << " = " << mistake.value;
}

// The entry of a map, or of a list if key is a number.
YAML::Node child(YAML::Node node, const std::string& key) {
  return node.IsSequence() ? node[std::stoi(key)] : node[key];
}

void put(YAML::Node node, const std::string& path, const std::string& value) {
  const std::size_t slash = path.find('/');
  const std::string key = path.substr(0, slash);
  if (slash != std::string::npos) {
    put(child(node, key), path.substr(slash + 1), value);
  } else if (value.empty()) {
    node.remove(key);
  } else {
    child(node, key) = YAML::Load(value);
  }
}

class RobotMistake : public testing::TestWithParam<Mistake> {};

TEST_P(RobotMistake, NamesKeyValueAndExpectation) {
  YAML::Node node = goodRobot();
  put(node, GetParam().path, GetParam().value);
  const std::string text = complaint(node);
  EXPECT_EQ(text.substr(0, GetParam().complaint.size()), GetParam().complaint) << text;
  EXPECT_TRUE(contains(text, "expected")) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Platform, RobotMistake,
    testing::Values(
        Mistake{"platform", "", "platform is missing: expected a map of keys"},
        Mistake{"platform", "[1]", "platform = [1]: expected a map of keys"},
        Mistake{"platform/type", "sphere", "platform.type = sphere: expected rigid_body or point_mass"},
        Mistake{"platform/mass", "", "platform.mass is missing: expected a number, finite and > 0 [kg]"},
        Mistake{"platform/mass", "~", "platform.mass = nothing"},
        Mistake{"platform/mass", "0", "platform.mass = 0: expected a number, finite and > 0 [kg]"},
        Mistake{"platform/mass", "-3", "platform.mass = -3"}, Mistake{"platform/mass", ".nan", "platform.mass = .nan"},
        Mistake{"platform/mass", "heavy", "platform.mass = heavy"},
        Mistake{"platform/mass", "true", "platform.mass = true"},
        Mistake{"platform/mass", "5 kg", "platform.mass = 5 kg"},
        Mistake{"platform/mass", "[5]", "platform.mass = [5]"},
        Mistake{"platform/com", "[0, 0]", "platform.com = [0, 0]: expected a list of 3 numbers, finite [m]"},
        Mistake{"platform/com", "[0, .inf, 0]", "platform.com = [0, .inf, 0]"},
        Mistake{"platform/com", "0", "platform.com = 0"},
        Mistake{"platform/size", "[1, 1, 0]",
                "platform.size = [1, 1, 0]: expected a list of 3 numbers, finite and > 0"},
        Mistake{"platform/position", "", "platform.position is missing"},
        Mistake{"platform/position", "[0, 0, 1]", "platform.position = [0, 0, 1]: expected a map of keys"},
        Mistake{"platform/position/xyz", "", "platform.position.xyz is missing: expected a list of 3 numbers"},
        Mistake{"platform/position/xyz", "[0, 0, x]", "platform.position.xyz = [0, 0, x]"},
        Mistake{"platform/position/rpy", "[0, 0, 0, 1]", "platform.position.rpy = [0, 0, 0, 1]"},
        Mistake{"gravity", "0", "gravity = 0: expected a number, finite and > 0 [m/s^2]"},
        Mistake{"gravity", "-9.81", "gravity = -9.81"}, Mistake{"name", "[a]", "name = [a]: expected a name"},
        Mistake{"name", "''", "name = \"\": expected a name"}));

INSTANTIATE_TEST_SUITE_P(
    Cables, RobotMistake,
    testing::Values(
        Mistake{"cable", "7", "cable = 7: expected a map of keys"},
        Mistake{"cable", "", "points[0].cable.axial_stiffness is missing and so is cable.axial_stiffness: expected EA"},
        Mistake{"cable/axial_stiffness", "0", "cable.axial_stiffness = 0: expected a number, finite and > 0 [N]"},
        Mistake{"cable/axial_stiffness", ".inf", "cable.axial_stiffness = .inf"},
        Mistake{"cable/bending_stiffness", "", "points[0].cable.bending_stiffness is missing"},
        Mistake{"cable/bending_stiffness", "-0.1",
                "cable.bending_stiffness = -0.1: expected a number, finite and >= 0"},
        Mistake{"cable/linear_density", "", "points[0].cable.linear_density is missing"},
        Mistake{"cable/linear_density", "-1", "cable.linear_density = -1"},
        Mistake{"cable/radius", "0", "cable.radius = 0"}, Mistake{"cable/diameter", "-1", "cable.diameter = -1"},
        Mistake{"cable/youngs_modulus", "0", "cable.youngs_modulus = 0"},
        Mistake{"cable/density", "-1", "cable.density = -1"},
        Mistake{"cable/density", "7850", "cable.density = 7850: expected radius or diameter beside it"},
        Mistake{"cable/fill_factor", "1.2", "cable.fill_factor = 1.2: expected a number, > 0 and <= 1"},
        Mistake{"cable/fill_factor", "0.6", "cable.fill_factor = 0.6: expected radius or diameter beside it"},
        Mistake{"cable/tension_max", "", "points[0].cable.tension_max is missing"},
        Mistake{"cable/tension_max", "0", "cable.tension_max = 0"},
        Mistake{"cable/tension_min", "-1", "cable.tension_min = -1"},
        Mistake{"cable/tension_min", "6000", "cable.tension_min = 6000: expected less than cable.tension_max = 5000"},
        Mistake{"points/2/cable", "{tension_max: 20}",
                "cable.tension_min = 20: expected less than points[2].cable.tension_max = 20"},
        Mistake{"points/1/cable", "{axial_stiffness: soft}", "points[1].cable.axial_stiffness = soft"}));

INSTANTIATE_TEST_SUITE_P(
    Points, RobotMistake,
    testing::Values(
        Mistake{"points", "", "points is missing: expected a list of at least one map"},
        Mistake{"points", "[]", "points = []"}, Mistake{"points", "{a: 1}", "points = {a: 1}"},
        Mistake{"points/1", "3", "points[1] = 3: expected a map of keys"},
        Mistake{"points/1/frame", "", "points[1].frame is missing"},
        Mistake{"points/1/frame", "[1, 2]", "points[1].frame = [1, 2]: expected a list of 3 numbers"},
        Mistake{"points/1/frame", "[0.9, 2, 3]", "points[1].frame = [0.9, 2, 3]: expected a point away from"},
        Mistake{"points/1/platform", "", "points[1].platform is missing"},
        Mistake{"points/1/platform", "[1, 2, z]", "points[1].platform = [1, 2, z]"},
        Mistake{"points/1/name", "cable0", "points[1].name = cable0: expected a name that no other cable has"},
        Mistake{"points/0/name", "cable2", "points[2].name = cable2: expected a name that no other cable has"},
        Mistake{"points/0/name", "{}", "points[0].name = {}: expected a name that is not empty"},
        Mistake{"platform/type", "point_mass", "platform.com = [0.1, 0.2, 0.3]: expected [0, 0, 0] for a point_mass"}));

TEST(RobotDescription, PointMassRefusesAttachmentAwayFromIt) {
  YAML::Node node = goodRobot();
  node["platform"]["type"] = "point_mass";
  node["platform"].remove("com");
  EXPECT_EQ(complaint(node), "points[0].platform = [0.1, 0, 0]: expected [0, 0, 0] for a point_mass");
}

TEST(RobotDescription, KeyGivenTwiceIsAnError) {
  EXPECT_TRUE(contains(complaint(YAML::Load("{name: a, name: b}")), "name is given twice"));
}

TEST(RobotDescription, NotAMapIsAnError) {
  EXPECT_EQ(complaint(YAML::Load("[1, 2]")), "robot = [1, 2]: expected a map of keys");
  EXPECT_EQ(complaint(YAML::Node()), "robot = nothing: expected a map of keys");
}

TEST(RobotDescription, HasAtMost256Cables) {
  YAML::Node node = goodRobot();
  const YAML::Node point = YAML::Load("{frame: [4, 4, 5], platform: [0.1, 0.1, 0]}");
  while (node["points"].size() < 256) node["points"].push_back(YAML::Clone(point));
  EXPECT_EQ(complaint(node), "");
  node["points"].push_back(YAML::Clone(point));
  EXPECT_EQ(complaint(node), "points has 257 cables: expected at most 256");
}

class BadFile : public testing::TestWithParam<std::string> {};

TEST_P(BadFile, IsNamed) {
  try {
    loadRobotFile(GetParam());
    FAIL() << GetParam() << " was read";
  } catch (const std::invalid_argument& error) {
    EXPECT_TRUE(contains(error.what(), GetParam() + ": expected")) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadFile, testing::Values("/nowhere/robot.yaml", ROBOT_DIR, __FILE__));

}  // namespace
}  // namespace cdpr_kinetostatics

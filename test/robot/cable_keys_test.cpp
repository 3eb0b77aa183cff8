// What the keys of a `cable` map come to. Mistakes in files are in robot_description_yaml_test.
#include "robot/cable_keys.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace cdpr_kinetostatics {
namespace {

constexpr double kGravity = 10.0;  // [m/s^2]

CableDescription cableOf(const std::string& yaml) {
  std::vector<std::string> warnings;
  CableDescription cable;
  resolveCable(readCableKeys(YamlMap(YAML::Load(yaml), "cable"), warnings), "cable", kGravity, cable);
  EXPECT_TRUE(warnings.empty());
  return cable;
}

TEST(CableKeys, PropertiesAsGiven) {
  const CableDescription cable =
      cableOf("{axial_stiffness: 2e5, bending_stiffness: 0.5, linear_density: 0.06, tension_min: 3, tension_max: 90}");
  EXPECT_EQ(cable.properties.axial_stiffness, 2e5);
  EXPECT_EQ(cable.properties.bending_stiffness, 0.5);
  EXPECT_DOUBLE_EQ(cable.properties.weight, 0.6);
  EXPECT_EQ(cable.tension_min, 3.0);
  EXPECT_EQ(cable.tension_max, 90.0);
}

TEST(CableKeys, PropertiesOfASolidRoundSection) {
  const CableDescription cable = cableOf("{diameter: 0.004, youngs_modulus: 2e11, density: 8000, tension_max: 90}");
  // A = pi d^2/4, I = pi d^4/64.
  const double area = M_PI * 0.004 * 0.004 / 4.0;
  const double second_moment = M_PI * std::pow(0.004, 4) / 64.0;
  EXPECT_NEAR(cable.properties.axial_stiffness, 2e11 * area, 1e-9 * 2e11 * area);
  EXPECT_NEAR(cable.properties.bending_stiffness, 2e11 * second_moment, 1e-9 * 2e11 * second_moment);
  EXPECT_NEAR(cable.properties.weight, 8000.0 * area * kGravity, 1e-9);
  EXPECT_EQ(cable.tension_min, 0.0);
}

TEST(CableKeys, AFillFactorScalesAreaAndMassButNotBending) {
  const std::string wire = "radius: 0.002, youngs_modulus: 2e11, density: 8000, tension_max: 90";
  const CableDescription solid = cableOf("{" + wire + "}");
  const CableDescription rope = cableOf("{" + wire + ", fill_factor: 0.5}");
  EXPECT_DOUBLE_EQ(rope.properties.axial_stiffness, 0.5 * solid.properties.axial_stiffness);
  EXPECT_DOUBLE_EQ(rope.properties.weight, 0.5 * solid.properties.weight);
  EXPECT_DOUBLE_EQ(rope.properties.bending_stiffness, solid.properties.bending_stiffness);
}

TEST(CableKeys, TwoSourcesMustAgree) {
  const GivenNumber first{100.0, "cable.axial_stiffness"};
  EXPECT_EQ(agree(first, std::nullopt)->value, 100.0);
  EXPECT_EQ(agree(std::nullopt, first)->value, 100.0);
  EXPECT_FALSE(agree(std::nullopt, std::nullopt));
  EXPECT_EQ(agree(first, GivenNumber{100.00001, "cable.radius"})->value, 100.0);
  EXPECT_THROW(agree(first, GivenNumber{100.001, "cable.radius"}), std::invalid_argument);
}

}  // namespace
}  // namespace cdpr_kinetostatics

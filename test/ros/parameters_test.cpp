#include "ros/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "robot/offsets_file.h"
#include "ros/conversions.h"
#include "yaml_parameters.h"

namespace cdpr_kinetostatics {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue goodParameters() {
  XmlRpcValue parameters;
  parameters["robot"] = robotParameter("cogiro");
  return parameters;
}

std::string refusal(const XmlRpcValue& parameters) {
  try {
    loadParameters(parameters);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

TEST(Parameters, DefaultsAreThoseOfTheManual) {
  const LoadedParameters loaded = loadParameters(goodParameters());
  EXPECT_EQ(loaded.parameters.model, Model::kAuto);
  EXPECT_EQ(loaded.parameters.accuracy, 1e-4);
  EXPECT_EQ(loaded.parameters.tolerance, 1e-8);
  EXPECT_EQ(loaded.parameters.timeout, 0.1);
  EXPECT_TRUE(loaded.warnings.empty());

  XmlRpcValue manual = toParameter(YAML::LoadFile(SOURCE_DIR "/config/node.yaml"));
  manual["robot"] = robotParameter("cogiro");
  const LoadedParameters from_manual = loadParameters(manual);
  EXPECT_EQ(from_manual.parameters.model, loaded.parameters.model);
  EXPECT_EQ(from_manual.parameters.accuracy, loaded.parameters.accuracy);
  EXPECT_EQ(from_manual.parameters.tolerance, loaded.parameters.tolerance);
  EXPECT_EQ(from_manual.parameters.timeout, loaded.parameters.timeout);
  EXPECT_TRUE(from_manual.warnings.empty());

  const NodeParameters& a = loaded.parameters;
  const NodeParameters& b = from_manual.parameters;
  EXPECT_EQ(a.estimator.model, Model::kAuto);
  EXPECT_EQ(a.estimator.accuracy, 1e-4);
  EXPECT_EQ(a.estimator.length_stddev, 1e-3);
  EXPECT_EQ(a.estimator.tension_stddev, 5.0);
  EXPECT_TRUE(a.estimator.known_load);
  EXPECT_NEAR(a.estimator.load_stddev(2), 0.01 * a.robot.weight(), 1e-9);
  EXPECT_EQ(a.estimator.outlier_threshold, 6.0);
  EXPECT_EQ(a.max_age, 0.5);
  EXPECT_EQ(a.base_frame, "world");
  EXPECT_EQ(a.platform_frame, "platform");
  EXPECT_TRUE(a.publish_tf);
  EXPECT_EQ(a.estimator.length_stddev, b.estimator.length_stddev);
  EXPECT_EQ(a.estimator.tension_stddev, b.estimator.tension_stddev);
  EXPECT_EQ(a.estimator.load_stddev, b.estimator.load_stddev);
  EXPECT_EQ(a.estimator.outlier_threshold, b.estimator.outlier_threshold);
  EXPECT_EQ(a.estimator.profile_points, b.estimator.profile_points);
  EXPECT_EQ(a.max_age, b.max_age);
  EXPECT_EQ(a.queue_size, b.queue_size);
  EXPECT_EQ(a.marker_rate, b.marker_rate);
}

TEST(Parameters, RobotIsTheSameAsFromTheFile) {
  for (const char* name : {"cogiro", "desktop_music_wire", "scampi", "paper_point_mass"}) {
    const RobotDescription file = loadRobotFile(std::string(ROBOT_DIR) + "/" + name + ".yaml").robot;
    XmlRpcValue parameters;
    parameters["robot"] = robotParameter(name);
    const RobotDescription server = loadParameters(parameters).parameters.robot;
    EXPECT_EQ(server.name, file.name);
    EXPECT_EQ(server.mass, file.mass);
    ASSERT_EQ(server.cables.size(), file.cables.size());
    for (std::size_t i = 0; i < file.cables.size(); ++i) {
      EXPECT_EQ(server.cables[i].name, file.cables[i].name);
      EXPECT_EQ(server.cables[i].anchor, file.cables[i].anchor);
      EXPECT_EQ(server.cables[i].attachment, file.cables[i].attachment);
      EXPECT_EQ(server.cables[i].properties.axial_stiffness, file.cables[i].properties.axial_stiffness);
      EXPECT_EQ(server.cables[i].properties.bending_stiffness, file.cables[i].properties.bending_stiffness);
      EXPECT_EQ(server.cables[i].properties.weight, file.cables[i].properties.weight);
      EXPECT_EQ(server.cables[i].tension_max, file.cables[i].tension_max);
    }
  }
}

TEST(Parameters, NumbersMayBeIntegersOrWrittenWithoutPoint) {
  XmlRpcValue parameters = goodParameters();
  parameters["timeout"] = 2;
  parameters["tolerance"] = "1e-6";  // a string by YAML 1.1
  const NodeParameters loaded = loadParameters(parameters).parameters;
  EXPECT_EQ(loaded.timeout, 2.0);
  EXPECT_EQ(loaded.tolerance, 1e-6);
}

TEST(Parameters, WrongOnesAreRefusedByNameAndValue) {
  struct Case {
    const char* key;
    XmlRpcValue value;
    const char* shown;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Case cases[] = {
      {"timeout", -1.0, "-1"},
      {"timeout", 0, "0"},
      {"timeout", nan, "nan"},
      {"timeout", "soon", "'soon'"},
      {"timeout", 1e9, "1000000000"},
      {"tolerance", 0.0, "0"},
      {"tolerance", 1.0, "1"},
      {"tolerance", "1e-8 m", "'1e-8 m'"},
      {"tolerance", true, "1"},
      {"length_stddev", 0.0, "0"},
      {"tension_stddev", -5.0, "-5"},
      {"known_load", "yes", "'yes'"},
      {"load_stddev", 9.0, "9"},
      {"outlier_threshold", nan, "nan"},
      {"max_age", 0, "0"},
      {"queue_size", 1.5, "1.5"},
      {"queue_size", 0, "0"},
      {"marker_rate", -1, "-1"},
      {"profile_points", 1, "1"},
      {"base_frame", "", "''"},
      {"platform_frame", "world", "'world'"},
      {"publish_tf", 1, "1"},
      {"model", "rigid", "'rigid'"},
      {"model", 8, "8"},
      {"model", "default", "'default'"},
      {"accuracy", 0, "0"},
      {"accuracy", -1e-3, "-0.001"},
  };
  for (const Case& wrong : cases) {
    XmlRpcValue parameters = goodParameters();
    parameters[wrong.key] = wrong.value;
    const std::string message = refusal(parameters);
    EXPECT_NE(message.find(std::string("~") + wrong.key), std::string::npos) << message;
    EXPECT_NE(message.find(wrong.shown), std::string::npos) << message;
  }
}

TEST(Parameters, RobotMustBeThereAndRight) {
  EXPECT_NE(refusal(XmlRpcValue()).find("~robot is missing"), std::string::npos);

  XmlRpcValue parameters = goodParameters();
  parameters["robot"] = "cogiro.yaml";
  EXPECT_NE(refusal(parameters).find("~robot"), std::string::npos);

  parameters = goodParameters();
  parameters["robot"]["platform"]["mass"] = -3.0;
  const std::string message = refusal(parameters);
  EXPECT_NE(message.find("mass"), std::string::npos) << message;
  EXPECT_NE(message.find("-3"), std::string::npos) << message;
}

TEST(Parameters, UnknownKeysAreNamed) {
  XmlRpcValue parameters = goodParameters();
  parameters["tolerence"] = 1e-6;
  const LoadedParameters loaded = loadParameters(parameters);
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_NE(loaded.warnings[0].find("~tolerence"), std::string::npos);
  EXPECT_EQ(loaded.parameters.tolerance, 1e-8);
}

TEST(ToYaml, KeepsEveryDigit) {
  const double value = 0.1 + 1e-16;
  EXPECT_EQ(toYaml(XmlRpcValue(value)).as<double>(), value);
  EXPECT_TRUE(std::isnan(toYaml(XmlRpcValue(std::nan(""))).as<double>()));
  EXPECT_THROW(toYaml(XmlRpcValue()), std::invalid_argument);
}

// Offsets that homing has written take the place of the description's; before, those hold.
TEST(OffsetsParameter, AreReadAtTheStart) {
  const std::string path = testing::TempDir() + "parameters_test_offsets.yaml";
  std::remove(path.c_str());
  XmlRpc::XmlRpcValue values;
  values["robot"] = robotParameter("cogiro");
  values["offsets_file"] = path;
  EXPECT_EQ(loadParameters(values).parameters.robot.cables[0].offset, 0.0);
  const RobotDescription robot = loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot;
  writeOffsets(path, robot, {0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08});
  EXPECT_EQ(loadParameters(values).parameters.robot.cables[7].offset, 0.08);
  values["robot"] = robotParameter("ipanema3");
  EXPECT_THROW(loadParameters(values), std::invalid_argument) << "another robot's";
  values["offsets_file"] = "/no/such/folder/offsets.yaml";
  EXPECT_THROW(loadParameters(values), std::invalid_argument);
  std::remove(path.c_str());
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The rig's parameters: defaults of the manual, wrong ones named with their value, lists read entry by entry.

#include "rig/parameters.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "yaml_parameters.h"

namespace cdpr_kinetostatics {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue parameters(const std::string& yaml) {
  XmlRpcValue values = toParameter(YAML::Load(yaml));
  values["robot"] = robotParameter("cogiro");
  return values;
}

std::string refusal(const std::string& yaml) {
  try {
    loadRigParameters(parameters(yaml));
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

TEST(RigParameters, DefaultsAreThoseOfTheManual) {
  XmlRpcValue manual = toParameter(YAML::LoadFile(SOURCE_DIR "/config/rig.yaml"));
  manual["robot"] = robotParameter("cogiro");
  const LoadedRigParameters from_manual = loadRigParameters(manual);
  XmlRpcValue robot_only;
  robot_only["robot"] = robotParameter("cogiro");
  const LoadedRigParameters defaults = loadRigParameters(robot_only);
  EXPECT_TRUE(from_manual.warnings.empty());
  EXPECT_TRUE(defaults.warnings.empty());
  for (const RigParameters* p : {&from_manual.parameters, &defaults.parameters}) {
    EXPECT_EQ(p->model, Model::kBending);
    EXPECT_EQ(p->tolerance, 1e-10);
    EXPECT_EQ(p->rate, 50.0);
    EXPECT_EQ(p->base_frame, "world");
    EXPECT_EQ(p->path.kind, RigPath::Kind::kCircle);
    EXPECT_FALSE(p->path.radius);
    EXPECT_EQ(p->path.period, 20.0);
    EXPECT_NEAR(p->path.speed, 0.02 * p->robot.span(), 1e-12);
    EXPECT_EQ(p->sensors.seed, 1);
    EXPECT_TRUE(p->sensors.tensions);
    EXPECT_EQ(p->sensors.length_noise, 0.0);
    EXPECT_EQ(p->sensors.dropout, 0.0);
    EXPECT_TRUE(p->sensors.faults.empty());
    EXPECT_TRUE(p->loads.empty());
    EXPECT_EQ(p->load_noise, 0.0);
  }
}

TEST(RigParameters, ListsAreRead) {
  const LoadedRigParameters loaded = loadRigParameters(parameters(R"(
path: waypoints
waypoints: [{xyz: [0, 0, 1.5]}, {xyz: [1, 0, 1.5], rpy: [0, 0, 0.1]}]
faults: [{kind: stuck_tension, cable: cable2, value: 900, start: 5.0, end: 10.0}, {kind: no_length, cable: cable7}]
loads: [{time: 5.0, wrench: [0, 0, -98.1, 0, 0, 0]}, {time: 1.0, wrench: [1, 2, 3, 4, 5, 6]}]
)"));
  EXPECT_TRUE(loaded.warnings.empty());
  const RigParameters& p = loaded.parameters;
  ASSERT_EQ(p.path.waypoints.size(), 2u);
  EXPECT_EQ(p.path.waypoints[1].position, Eigen::Vector3d(1.0, 0.0, 1.5));
  EXPECT_NEAR(p.path.waypoints[1].orientation.angularDistance(p.path.waypoints[0].orientation), 0.1, 1e-12);
  ASSERT_EQ(p.sensors.faults.size(), 2u);
  EXPECT_EQ(p.sensors.faults[0].kind, RigFault::Kind::kStuckTension);
  EXPECT_EQ(p.sensors.faults[0].cable, 2u);
  EXPECT_EQ(p.sensors.faults[0].value, 900.0);
  EXPECT_EQ(p.sensors.faults[0].start, 5.0);
  EXPECT_EQ(p.sensors.faults[0].end, 10.0);
  EXPECT_EQ(p.sensors.faults[1].kind, RigFault::Kind::kNoLength);
  EXPECT_GT(p.sensors.faults[1].end, 1e8) << "without an end it stays";
  ASSERT_EQ(p.loads.size(), 2u);
  EXPECT_EQ(p.loads[0].time, 1.0) << "in the order of time";
  EXPECT_EQ(p.loads[1].wrench(2), -98.1);
}

TEST(RigParameters, WrongOnesAreRefusedByNameAndValue) {
  struct Case {
    const char* yaml;
    const char* key;
    const char* shown;
  };
  const Case cases[] = {
      {"rate: 0", "~rate", "0"},
      {"rate: fast", "~rate", "'fast'"},
      {"model: rigid", "~model", "'rigid'"},
      {"path: square", "~path", "'square'"},
      {"path_radius: -1.0", "~path_radius", "-1"},
      {"path_period: 0", "~path_period", "0"},
      {"speed: 0", "~speed", "0"},
      {"path: waypoints", "~waypoints", "missing"},
      {"{path: waypoints, waypoints: [{xyz: [0, 0, 1]}]}", "~waypoints", "at least two"},
      {"waypoints: [{xyz: [0, 0]}]", "~waypoints[0]/xyz", "3 numbers"},
      {"waypoints: [{rpy: [0, 0, 0]}]", "~waypoints[0]/xyz", "missing"},
      {"waypoints: 3", "~waypoints", "3"},
      {"seed: 1.5", "~seed", "1.5"},
      {"tensions: 'no'", "~tensions", "no"},
      {"length_noise: -0.001", "~length_noise", "-0.001"},
      {"dropout: 1.5", "~dropout", "1.5"},
      {"load_noise: -1.0", "~load_noise", "-1"},
      {"faults: [{kind: broken, cable: cable0}]", "~faults[0]/kind", "'broken'"},
      {"faults: [{kind: no_length, cable: cable0}, {kind: no_length, cable: cable9}]", "~faults[1]/cable", "'cable9'"},
      {"faults: [{kind: no_length, cable: cable0, start: 5.0, end: 4.0}]", "~faults[0]/end", "4"},
      {"faults: [stuck]", "~faults", "list of maps"},
      {"loads: [{time: 1.0}]", "~loads[0]/wrench", "missing"},
      {"loads: [{time: -1.0, wrench: [0, 0, 0, 0, 0, 0]}]", "~loads[0]/time", "-1"},
      {"loads: [{wrench: [0, 0, 0]}]", "~loads[0]/wrench", "6 numbers"},
  };
  for (const Case& wrong : cases) {
    const std::string message = refusal(wrong.yaml);
    EXPECT_NE(message.find(wrong.key), std::string::npos) << wrong.yaml << ": " << message;
    EXPECT_NE(message.find(wrong.shown), std::string::npos) << wrong.yaml << ": " << message;
  }
}

TEST(RigParameters, UnknownKeysAreNamed) {
  const LoadedRigParameters loaded =
      loadRigParameters(parameters("{nois: 1.0, faults: [{kind: no_length, cable: cable0, until: 3.0}]}"));
  ASSERT_EQ(loaded.warnings.size(), 2u);
  EXPECT_NE(loaded.warnings[0].find("~faults[0]/until"), std::string::npos) << loaded.warnings[0];
  EXPECT_NE(loaded.warnings[1].find("~nois"), std::string::npos) << loaded.warnings[1];
}

TEST(RigParameters, RobotMustBeThere) {
  try {
    loadRigParameters(XmlRpcValue());
    FAIL();
  } catch (const std::invalid_argument& problem) {
    EXPECT_NE(std::string(problem.what()).find("~robot is missing"), std::string::npos) << problem.what();
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

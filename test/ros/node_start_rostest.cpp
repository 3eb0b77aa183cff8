// How the node starts: right parameters are told, wrong ones end it with a sentence that names them.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "node_client.h"
#include "node_process.h"
#include "yaml_parameters.h"

namespace cdpr_kinetostatics {
namespace {

using XmlRpc::XmlRpcValue;

// Starts a node with these parameters; expects that it exits 1 and says `words`.
void expectRefusal(const std::string& name, const XmlRpcValue& parameters, const std::vector<std::string>& words) {
  SCOPED_TRACE(name);
  ros::param::set("/" + name, parameters);
  NodeProcess node(name);
  EXPECT_EQ(node.exitCode(), 1);
  for (const std::string& word : words) EXPECT_NE(node.output().find(word), std::string::npos) << node.output();
}

XmlRpcValue withRobot() {
  XmlRpcValue parameters;
  parameters["robot"] = robotParameter("cogiro");
  return parameters;
}

TEST(NodeStart, TellsWhatItLoadedAndOffers) {
  XmlRpcValue parameters = withRobot();
  parameters["model"] = "bending";
  parameters["tolerance"] = 1e-6;
  parameters["colour"] = "red";
  ros::param::set("/good", parameters);
  NodeProcess node("good");
  ASSERT_TRUE(node.waitFor("/good/solve_cable")) << node.output();
  for (const char* words :
       {"'cogiro'", "8 cables", "bending", "1e-06", "~colour is unknown", "/good/forward_kinetostatics"}) {
    EXPECT_NE(node.output().find(words), std::string::npos) << words << " in\n" << node.output();
  }
  SolveCable::Request request;
  request.cable_name = "no such cable";
  request.problem = SolveCable::Request::FIND_FORCES;
  EXPECT_EQ(NodeClient("/good").cable(request).report.code, SolveReport::UNKNOWN_CABLE);
  node.interrupt();
  EXPECT_EQ(node.exitCode(), 0);
}

TEST(NodeStart, LaunchFileDeletesWhatAnotherRobotLeft) {
  ros::param::set("/kinetostatics/robot/platform/com", std::vector<double>{0.1, 0.2, 0.3});
  ros::param::set("/kinetostatics/tolerance", 1e-3);
  NodeProcess launch("/usr/bin/env",
                     {"roslaunch", "cdpr_kinetostatics", "kinetostatics.launch", "robot:=paper_point_mass"});
  EXPECT_TRUE(launch.waitFor("/kinetostatics/solve_cable")) << launch.output();
  EXPECT_FALSE(ros::param::has("/kinetostatics/robot/platform/com")) << "a point mass with a com is refused";
  EXPECT_EQ(ros::param::param("/kinetostatics/tolerance", 0.0), 1e-8);
  launch.interrupt();
  EXPECT_EQ(launch.exitCode(), 0) << launch.output();
}

TEST(NodeStart, NeedsARobot) {
  ros::param::del("/no_robot");
  NodeProcess node("no_robot");
  EXPECT_EQ(node.exitCode(), 1);
  EXPECT_NE(node.output().find("~robot is missing"), std::string::npos) << node.output();
}

TEST(NodeStart, RefusesWrongRobots) {
  XmlRpcValue parameters = withRobot();
  parameters["robot"]["platform"]["mass"] = "heavy";
  expectRefusal("mass_is_a_word", parameters, {"mass", "heavy"});

  parameters = withRobot();
  parameters["robot"]["cable"]["axial_stiffness"] = -1.0;
  expectRefusal("negative_stiffness", parameters, {"axial_stiffness", "-1"});

  parameters = withRobot();
  parameters["robot"]["points"] = "none";
  expectRefusal("no_points", parameters, {"points", "none"});

  parameters = withRobot();
  parameters["robot"]["points"][2]["frame"][0] = std::numeric_limits<double>::quiet_NaN();
  expectRefusal("anchor_nan", parameters, {"points[2]", "frame", "nan"});
}

TEST(NodeStart, RefusesWrongNumbersAndModels) {
  XmlRpcValue parameters = withRobot();
  parameters["timeout"] = -0.5;
  expectRefusal("negative_timeout", parameters, {"~timeout", "-0.5"});

  parameters = withRobot();
  parameters["tolerance"] = "fine";
  expectRefusal("tolerance_is_a_word", parameters, {"~tolerance", "'fine'"});

  parameters = withRobot();
  parameters["model"] = "rigid";
  expectRefusal("model_unknown", parameters, {"~model", "rigid", "auto", "bending"});
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ros_node_start_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

// A file has one meaning: the robot that roslaunch puts on the parameter server is the one that programs without ROS
// read.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "ros/parameter_reader.h"
#include "ros/parameters.h"

namespace cdpr_kinetostatics {
namespace {

RobotDescription fromServer(std::vector<std::string>* warnings) {
  XmlRpc::XmlRpcValue values;
  ros::param::get(ros::this_node::getName(), values);
  ParameterReader reader(values);
  return readRobot(reader, warnings);
}

TEST(OneReading, NodeAndProgramsReadTheSameRobot) {
  std::vector<std::string> warnings;
  const RobotDescription node = fromServer(&warnings);
  const LoadedRobot file = loadRobotFile(SOURCE_DIR "/test/ros/one_reading.yaml");
  const RobotDescription& program = file.robot;
  EXPECT_EQ(warnings.size(), file.warnings.size());
  EXPECT_EQ(node.gravity, program.gravity);
  EXPECT_EQ(node.mass, program.mass);
  EXPECT_EQ(node.com, program.com);
  EXPECT_EQ(node.size, program.size);
  EXPECT_EQ(node.home.position, program.home.position);
  EXPECT_EQ(node.home.orientation.coeffs(), program.home.orientation.coeffs());
  ASSERT_EQ(node.cables.size(), program.cables.size());
  for (std::size_t i = 0; i < node.cables.size(); ++i) {
    SCOPED_TRACE(i);
    const CableDescription& a = node.cables[i];
    const CableDescription& b = program.cables[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.anchor, b.anchor);
    EXPECT_EQ(a.attachment, b.attachment);
    EXPECT_EQ(a.tension_min, b.tension_min);
    EXPECT_EQ(a.tension_max, b.tension_max);
    EXPECT_EQ(a.properties.axial_stiffness, b.properties.axial_stiffness);
    EXPECT_EQ(a.properties.bending_stiffness, b.properties.bending_stiffness);
    EXPECT_EQ(a.properties.weight, b.properties.weight);
  }
}

TEST(OneReading, IsThatOfRoslaunch) {
  std::vector<std::string> warnings;
  const RobotDescription robot = fromServer(&warnings);
  EXPECT_EQ(robot.mass, 8.0);
  EXPECT_EQ(robot.cables[0].name, "7");
  EXPECT_EQ(robot.cables[1].name, "yes");
  EXPECT_EQ(robot.cables[0].tension_min, 20.0);
  EXPECT_EQ(robot.cables[0].tension_max, 5000.0);
  EXPECT_EQ(robot.cables[2].properties.axial_stiffness, 1e5);
  EXPECT_EQ(robot.cables[2].tension_max, 5000.0);
  EXPECT_EQ(robot.cables[3].tension_min, 1.0);
  EXPECT_EQ(robot.cables[3].tension_max, 1000.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ros_one_reading_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

// launch/kinetostatics.launch respawn:=true starts a node again that was killed, with the same parameters.

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include <csignal>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "node_api.h"
#include "node_client.h"
#include "ros/conversions.h"

namespace cdpr_kinetostatics {
namespace {

constexpr const char* kNode = "/kinetostatics";

InverseKinetostatics::Response ask() {
  InverseKinetostatics::Request request;
  request.pose = toMsg(loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot.home);
  request.options.model = SolverOptions::CATENARY;
  request.options.timeout = ros::Duration(20.0);
  return NodeClient(kNode).inverse(request);
}

template <typename Condition>
bool waitFor(const Condition& condition) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(60.0);
  while (!condition() && ros::WallTime::now() < deadline) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
  }
  return condition();
}

// The first estimate from the lengths and tensions of an answer, and the frames of the transform with it.
void expectEstimate(const InverseKinetostatics::Response& answer) {
  ros::NodeHandle handle;
  sensor_msgs::JointState message;
  for (const CableState& cable : answer.cables) {
    message.name.push_back(cable.name);
    message.position.push_back(cable.length);
    message.effort.push_back(cable.tension_a);
  }
  std::vector<geometry_msgs::PoseWithCovarianceStamped> poses;
  std::vector<std::string> frames;
  const boost::function<void(const geometry_msgs::PoseWithCovarianceStamped&)> on_pose = [&](const auto& m) {
    poses.push_back(m);
  };
  const boost::function<void(const tf2_msgs::TFMessage&)> on_tf = [&](const auto& m) {
    for (const auto& t : m.transforms) frames.push_back(t.header.frame_id + " " + t.child_frame_id);
  };
  const auto pose_subscriber = handle.subscribe<geometry_msgs::PoseWithCovarianceStamped>("platform_pose", 10, on_pose);
  const auto tf_subscriber = handle.subscribe<tf2_msgs::TFMessage>("/tf", 10, on_tf);
  const ros::Publisher publisher = handle.advertise<sensor_msgs::JointState>("measurements", 10);
  ASSERT_TRUE(waitFor([&] {
    message.header.stamp = ros::Time::now();
    publisher.publish(message);
    return !poses.empty() && !frames.empty();
  }));
  const Pose expected = fromMsg(answer.pose);
  EXPECT_LT((fromMsg(poses[0].pose.pose).position - expected.position).norm(), 1e-4) << "the node's accuracy";
  EXPECT_EQ(poses[0].header.frame_id, "hall");
  EXPECT_EQ(frames[0], "hall hook");
}

TEST(Respawn, NodeThatIsKilledComesBackWithTheSameAnswers) {
  const InverseKinetostatics::Response before = ask();
  ASSERT_EQ(before.report.code, SolveReport::CONVERGED) << before.report.message;
  expectEstimate(before);
  const int pid = pidOf(kNode);
  ASSERT_GT(pid, 0);
  ASSERT_EQ(kill(pid, SIGKILL), 0);
  ASSERT_TRUE(waitFor([&] {
    const int now = pidOf(kNode);
    return now > 0 && now != pid;
  }));
  EXPECT_EQ(ask().lengths, before.lengths);
  expectEstimate(before);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ros_respawn_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

// The node's memory does not grow with the messages that it has seen.
#include <gtest/gtest.h>

#include "counted_allocations.h"
#include "node_path.h"

namespace cdpr_kinetostatics {
namespace {

class NodeMemory : public ::testing::TestWithParam<Model> {};

TEST_P(NodeMemory, IsFlatOverMessages) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  EstimatorOptions options;
  options.model = GetParam();
  options.timeout = std::chrono::duration<double>(10.0);
  options.load_stddev = EstimatorOptions::defaultLoadStddev(robot);
  options.profile_points = 10;
  MessageStream stream(robot, GetParam());
  NodePath node(robot, options);
  constexpr int kMessages = 300;
  const auto run = [&] {
    for (int i = 0; i < kMessages; ++i) {
      const sensor_msgs::JointState message = stream.next();
      node.process(message, ros::Time(1.0 + (node.counts().received + 1) / MessageStream::kRate));
    }
    return heapCount().bytes;
  };
  const long first = run();
  const long second = run();
  const long third = run();
  // Sentences about the last message, at most.
  EXPECT_LT(std::abs(second - first), 2000);
  EXPECT_LT(std::abs(third - first), 2000);
  EXPECT_EQ(node.counts().received, 3 * kMessages);
  EXPECT_GT(node.counts().refused(), 10u);
  EXPECT_GT(node.status().solves, 800u);
  EXPECT_LT(node.status().failures, 10u);
  EXPECT_GT(node.bytes(), 1000000u);
}

INSTANTIATE_TEST_SUITE_P(Models, NodeMemory, ::testing::Values(Model::kCatenary, Model::kBending));

}  // namespace
}  // namespace cdpr_kinetostatics

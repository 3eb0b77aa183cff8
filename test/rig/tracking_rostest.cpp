// The estimator follows the simulated rig: exactly without noise, and within its own covariance with noise.

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "ros/conversions.h"

namespace cdpr_kinetostatics {
namespace {

struct Pair {
  Pose estimated, truth;
  Eigen::Matrix<double, 6, 6> covariance;

  // Of position and attitude (rotation vector in the world).
  Eigen::Matrix<double, 6, 1> error() const {
    const Eigen::AngleAxisd turn(estimated.orientation * truth.orientation.conjugate());
    const double angle = turn.angle() > M_PI ? turn.angle() - 2.0 * M_PI : turn.angle();
    Eigen::Matrix<double, 6, 1> e;
    e << estimated.position - truth.position, angle * turn.axis();
    return e;
  }
};

// Collects estimates and truths of the same stamp until there are `count`, or time is up.
std::vector<Pair> track(const std::string& space, std::size_t count) {
  ros::NodeHandle handle(space);
  std::map<ros::Time, Pose> truths;
  std::map<ros::Time, geometry_msgs::PoseWithCovariance> estimates;
  const boost::function<void(const geometry_msgs::PoseStamped&)> on_truth = [&](const auto& m) {
    truths[m.header.stamp] = fromMsg(m.pose);
  };
  const boost::function<void(const geometry_msgs::PoseWithCovarianceStamped&)> on_estimate = [&](const auto& m) {
    estimates[m.header.stamp] = m.pose;
  };
  const ros::Subscriber truth = handle.subscribe<geometry_msgs::PoseStamped>("true_pose", 10000, on_truth);
  const ros::Subscriber estimate =
      handle.subscribe<geometry_msgs::PoseWithCovarianceStamped>("platform_pose", 10000, on_estimate);
  std::vector<Pair> pairs;
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(60.0);
  while (pairs.size() < count && ros::WallTime::now() < deadline) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
    for (auto it = estimates.begin(); it != estimates.end();) {
      const auto same_stamp = truths.find(it->first);
      if (same_stamp == truths.end()) {
        ++it;
        continue;
      }
      Pair pair;
      pair.estimated = fromMsg(it->second.pose);
      pair.truth = same_stamp->second;
      for (int i = 0; i < 36; ++i) pair.covariance(i / 6, i % 6) = it->second.covariance[static_cast<std::size_t>(i)];
      pairs.push_back(pair);
      it = estimates.erase(it);
    }
  }
  return pairs;
}

class Tracking : public testing::TestWithParam<const char*> {};

TEST_P(Tracking, IsExactWithoutNoise) {
  const std::vector<Pair> pairs = track(std::string("/") + GetParam(), 60);
  ASSERT_GE(pairs.size(), 60u) << "too few estimates";
  const bool is_point = std::string(GetParam()) == "paper_point_mass";
  double moved = 0.0;
  for (const Pair& pair : pairs) {
    EXPECT_LT(pair.error().head<3>().norm(), 1e-6);
    if (!is_point) {
      EXPECT_LT(pair.error().tail<3>().norm(), 1e-6);
    }
    moved = std::max(moved, (pair.truth.position - pairs.front().truth.position).norm());
  }
  EXPECT_GT(moved, 1e-3) << "the platform stood still";
}

INSTANTIATE_TEST_SUITE_P(Robots, Tracking,
                         testing::Values("cogiro", "desktop_music_wire", "scampi", "paper_point_mass"),
                         [](const auto& robot) { return robot.param; });

TEST(Auto, StaysWithinTheAccuracyAskedFor) {
  const std::vector<Pair> pairs = track("/auto", 60);
  ASSERT_GE(pairs.size(), 60u) << "too few estimates";
  for (const Pair& pair : pairs) EXPECT_LT(pair.error().head<3>().norm(), 1e-4);
}

// The mean of the normalised squared error of n independent estimates is 6 with a standard deviation of
// sqrt(12/n): 0.2 for 300. Five of these are allowed.
TEST(Noise, ErrorsAreAsLargeAsTheCovarianceSays) {
  constexpr std::size_t kCount = 300;
  const std::vector<Pair> pairs = track("/noise", kCount);
  ASSERT_GE(pairs.size(), kCount) << "too few estimates";
  double sum = 0.0;
  for (const Pair& pair : pairs) {
    sum += pair.error().dot(pair.covariance.ldlt().solve(pair.error()));
    EXPECT_LT(pair.error().head<3>().norm(), 0.02);
  }
  EXPECT_NEAR(sum / static_cast<double>(pairs.size()), 6.0, 1.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rig_tracking_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

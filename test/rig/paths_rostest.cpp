// The rig goes where it is told: figure of eight, waypoints, target_pose, and the marker that is dragged in RViz.

#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/InteractiveMarkerInit.h>

#include <algorithm>
#include <cmath>

#include "scene.h"

namespace cdpr_kinetostatics {
namespace {

const Eigen::Vector3d kHome(0.0, 0.0, 1.5);  // CoGiRo's [m]

Eigen::Vector3d positionOf(const geometry_msgs::PoseStamped& pose) { return fromMsg(pose.pose).position; }

double lastDistanceTo(const RigScene& scene, const Eigen::Vector3d& point) {
  return scene.truths.empty() ? 1e9 : (positionOf(scene.truths.rbegin()->second) - point).norm();
}

// Between two messages the platform moves by the speed times 1/rate; a message may be missing in between.
void expectNoJumps(const RigScene& scene, double step) {
  ASSERT_GT(scene.truths.size(), 10u);
  for (auto next = std::next(scene.truths.begin()); next != scene.truths.end(); ++next) {
    const double moved = (positionOf(next->second) - positionOf(std::prev(next)->second)).norm();
    EXPECT_LE(moved, step * (1.0 + 1e-9));
  }
}

geometry_msgs::Pose pose(double x, double y, double z, double yaw = 0.0) {
  geometry_msgs::Pose p;
  p.position.x = x;
  p.position.y = y;
  p.position.z = z;
  p.orientation.z = std::sin(0.5 * yaw);
  p.orientation.w = std::cos(0.5 * yaw);
  return p;
}

TEST(RigPaths, FigureOfEightIsTracked) {
  RigScene scene("eight", "cogiro", "{path: figure_of_eight, path_radius: 0.4, path_period: 2.0}");
  scene.start();
  Eigen::Vector3d most = Eigen::Vector3d::Zero();
  ASSERT_TRUE(waitFor([&] {
    for (const auto& [stamp, truth] : scene.truths) most = most.cwiseMax((positionOf(truth) - kHome).cwiseAbs());
    return most.x() > 0.39 && most.y() > 0.19 && scene.poses.size() > 200;
  })) << most.transpose();
  for (const auto& [stamp, truth] : scene.truths) {
    const Eigen::Vector3d p = (positionOf(truth) - kHome) / 0.4;
    EXPECT_NEAR(std::pow(p.x(), 4), std::pow(p.x(), 2) - std::pow(p.y(), 2), 1e-9);
  }
  EXPECT_LT(scene.largestError(), 1e-6);
}

TEST(RigPaths, WaypointsAreVisited) {
  RigScene scene("waypoints", "cogiro",
                 "{path: waypoints, speed: 0.5, waypoints: [{xyz: [0, 0, 1.5]}, {xyz: [0.5, 0, 1.5]}, "
                 "{xyz: [0.5, 0.5, 1.8], rpy: [0, 0, 0.1]}]}");
  scene.start();
  const Eigen::Vector3d corners[] = {kHome, {0.5, 0.0, 1.5}, {0.5, 0.5, 1.8}};
  const auto all_visited = [&] {
    return std::all_of(std::begin(corners), std::end(corners), [&](const Eigen::Vector3d& corner) {
      return std::any_of(scene.truths.begin(), scene.truths.end(),
                         [&](const auto& truth) { return (positionOf(truth.second) - corner).norm() <= 0.5 * 0.01; });
    });
  };
  ASSERT_TRUE(waitFor([&] { return all_visited() && scene.poses.size() > 100; }));
  expectNoJumps(scene, 0.5 * 0.01);
  EXPECT_LT(scene.largestError(), 1e-6);
}

TEST(RigPaths, TargetIsReachedAtTheSpeedAndWrongOnesAreIgnored) {
  RigScene scene("target", "cogiro", "{path: target, speed: 0.5}");
  scene.start();
  const ros::Publisher publisher = scene.handle().advertise<geometry_msgs::PoseStamped>("target_pose", 10);
  ASSERT_TRUE(waitFor([&] { return publisher.getNumSubscribers() > 0 && !scene.truths.empty(); }));
  EXPECT_LT(lastDistanceTo(scene, kHome), 1e-12) << "without a target it stays at home";
  geometry_msgs::PoseStamped target;
  target.header.frame_id = "world";
  target.pose = pose(0.4, 0.3, 1.7, 0.1);
  publisher.publish(target);
  ASSERT_TRUE(waitFor([&] { return lastDistanceTo(scene, {0.4, 0.3, 1.7}) == 0.0; }));
  EXPECT_NEAR(scene.truths.rbegin()->second.pose.orientation.z, std::sin(0.05), 1e-9);
  expectNoJumps(scene, 0.5 * 0.01);

  // Each of these is ignored; the good one after them shows that they have been read.
  target.pose.position.x = std::nan("");
  publisher.publish(target);
  target.pose = pose(0.1, 0.1, 1.5);
  target.pose.orientation.w = 0.0;
  publisher.publish(target);
  target.pose = pose(0.2, 0.2, 1.5);
  target.header.frame_id = "camera";
  publisher.publish(target);
  target.pose = pose(0.0, 0.3, 1.7);
  target.header.frame_id = "";
  publisher.publish(target);
  ASSERT_TRUE(waitFor([&] { return lastDistanceTo(scene, {0.0, 0.3, 1.7}) == 0.0; }));
  for (const auto& [stamp, truth] : scene.truths) {
    ASSERT_TRUE(positionOf(truth).allFinite());
    EXPECT_GE(positionOf(truth).z(), 1.5) << "none of the wrong targets was on its way";
  }
  EXPECT_LT(scene.largestError(), 1e-6);
}

TEST(RigPaths, TargetOutOfReachStopsThePlatformWhereItCanBe) {
  RigScene scene("far_target", "cogiro", "{path: target, speed: 2.0}");
  scene.start();
  const ros::Publisher publisher = scene.handle().advertise<geometry_msgs::PoseStamped>("target_pose", 10);
  ASSERT_TRUE(waitFor([&] { return publisher.getNumSubscribers() > 0; }));
  geometry_msgs::PoseStamped target;
  target.pose = pose(0.0, 0.0, 50.0);
  publisher.publish(target);
  const auto stands_high = [&] {
    if (scene.truths.size() < 100) return false;
    const auto last = scene.truths.rbegin();
    const Eigen::Vector3d now = positionOf(last->second), before = positionOf(std::next(last, 50)->second);
    return now.z() > 2.0 && now == before;
  };
  ASSERT_TRUE(waitFor(stands_high));
  EXPECT_LT(positionOf(scene.truths.rbegin()->second).z(), 6.0) << "the anchors are below";
  target.pose = pose(0.0, 0.0, 1.5);
  publisher.publish(target);
  EXPECT_TRUE(waitFor([&] { return lastDistanceTo(scene, kHome) == 0.0; })) << "it can still be sent back";
  EXPECT_LT(scene.largestError(), 1e-6);
}

// What RViz publishes while somebody drags.
TEST(RigPaths, MarkerCanBeDragged) {
  using Feedback = visualization_msgs::InteractiveMarkerFeedback;
  using Init = visualization_msgs::InteractiveMarkerInit;
  RigScene scene("marker", "cogiro", "{path: target, speed: 0.5}");
  Init offered;
  const boost::function<void(const Init&)> on_init = [&](const Init& m) { offered = m; };
  const ros::Subscriber subscriber = scene.handle().subscribe<Init>("target_marker/update_full", 10, on_init);
  const ros::Publisher publisher = scene.handle().advertise<Feedback>("target_marker/feedback", 10);
  scene.start();
  ASSERT_TRUE(waitFor([&] { return !offered.markers.empty() && publisher.getNumSubscribers() > 0; }));
  const visualization_msgs::InteractiveMarker& marker = offered.markers[0];
  EXPECT_EQ(marker.name, "target");
  EXPECT_EQ(marker.header.frame_id, "world");
  EXPECT_NEAR((fromMsg(marker.pose).position - kHome).norm(), 0.0, 1e-12);
  ASSERT_EQ(marker.controls.size(), 6u) << "three axes to move along, three to turn about";
  EXPECT_GT(marker.scale, 0.1) << "large enough to be grasped on a robot of 15 m";

  Feedback drag;
  drag.header.frame_id = "world";
  drag.client_id = "/rviz";
  drag.marker_name = "target";
  drag.event_type = Feedback::POSE_UPDATE;
  for (int k = 1; k <= 10; ++k) {
    drag.pose = pose(0.03 * k, 0.0, 1.5);
    publisher.publish(drag);
  }
  drag.event_type = Feedback::MOUSE_UP;
  publisher.publish(drag);
  EXPECT_TRUE(waitFor([&] { return lastDistanceTo(scene, {0.3, 0.0, 1.5}) < 1e-12; }));
  expectNoJumps(scene, 0.5 * 0.01);
  EXPECT_LT(scene.largestError(), 1e-6);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rig_paths_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

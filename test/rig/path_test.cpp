// Paths of the simulated rig: start at home, return, have no jumps, and are the curves that their names say.

#include "rig/path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kRadius = 0.5;  // [m]
constexpr double kPeriod = 8.0;  // [s]

RobotDescription robot(const std::string& name) { return loadRobotFile(ROBOT_DIR "/" + name + ".yaml").robot; }

RigPath curve(RigPath::Kind kind) {
  RigPath path;
  path.kind = kind;
  path.period = kPeriod;
  return path;
}

Pose poseAt(double x, double y, double z, double yaw) {
  Pose pose;
  pose.position = {x, y, z};
  pose.orientation = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  return pose;
}

double turn(const Pose& a, const Pose& b) { return a.orientation.angularDistance(b.orientation); }

// Over two laps: no step is longer than the speed allows, the second lap is the first, and it starts at `start`.
void expectClosedAndContinuous(const FixedPath& path, double speed, double turn_rate, const Pose& start) {
  constexpr int kSteps = 4000;
  const double lap = path.duration();
  const double step = 2.0 * lap / kSteps;
  EXPECT_LT((path.at(0.0).position - start.position).norm(), 1e-12);
  for (int k = 0; k < kSteps; ++k) {
    const Pose here = path.at(k * step), next = path.at((k + 1) * step), lap_later = path.at(k * step + lap);
    ASSERT_LE((next.position - here.position).norm(), speed * step * (1.0 + 1e-9) + 1e-12) << k;
    ASSERT_LE(turn(next, here), turn_rate * step * (1.0 + 1e-6) + 1e-7) << k;
    ASSERT_LT((lap_later.position - here.position).norm(), 1e-9) << k;
  }
}

TEST(Circle, IsLevelAndRound) {
  const RobotDescription cogiro = robot("cogiro");
  const FixedPath path(cogiro, curve(RigPath::Kind::kCircle), kRadius);
  EXPECT_EQ(path.duration(), kPeriod);
  expectClosedAndContinuous(path, 2.0 * M_PI * kRadius / kPeriod, 0.0, cogiro.home);
  const Eigen::Vector3d centre = 0.5 * (path.at(0.0).position + path.at(0.5 * kPeriod).position);
  for (double time = 0.0; time < kPeriod; time += 0.1) {
    EXPECT_NEAR((path.at(time).position - centre).norm(), kRadius, 1e-12);
    EXPECT_NEAR(path.at(time).position.z(), cogiro.home.position.z(), 1e-12);
  }
}

TEST(Circle, OfAPointMassOnTwoCablesIsInTheirPlane) {
  const RobotDescription point = robot("paper_point_mass");
  const FixedPath path(point, curve(RigPath::Kind::kCircle), 0.01);
  const Eigen::Vector3d across = (point.cables[1].anchor - point.cables[0].anchor).cross(Eigen::Vector3d::UnitZ());
  double height = 0.0;
  for (double time = 0.0; time < kPeriod; time += 0.1) {
    const Eigen::Vector3d moved = path.at(time).position - point.home.position;
    EXPECT_NEAR(moved.dot(across), 0.0, 1e-12);
    height = std::max(height, moved.z());
  }
  EXPECT_NEAR(height, 0.02, 1e-4);
}

TEST(FigureOfEight, IsALemniscateThroughHome) {
  const RobotDescription cogiro = robot("cogiro");
  const FixedPath path(cogiro, curve(RigPath::Kind::kFigureOfEight), kRadius);
  expectClosedAndContinuous(path, 2.0 * M_PI * std::sqrt(2.0) * kRadius / kPeriod, 0.0, cogiro.home);
  EXPECT_LT((path.at(0.5 * kPeriod).position - cogiro.home.position).norm(), 1e-12) << "it crosses itself at home";
  Eigen::Vector3d most = Eigen::Vector3d::Zero();
  for (double time = 0.0; time < kPeriod; time += 0.05) {
    const Eigen::Vector3d moved = (path.at(time).position - cogiro.home.position) / kRadius;
    EXPECT_NEAR(std::pow(moved.x(), 4), std::pow(moved.x(), 2) - std::pow(moved.y(), 2), 1e-12);  // Gerono's
    most = most.cwiseMax(moved);
  }
  EXPECT_NEAR(most.x(), 1.0, 1e-3);
  EXPECT_NEAR(most.y(), 0.5, 1e-3);
}

TEST(Waypoints, AreAllVisitedAtTheSpeedGiven) {
  RigPath way;
  way.kind = RigPath::Kind::kWaypoints;
  way.speed = 0.25;
  // A straight leg, a pure turn, and both together.
  way.waypoints = {poseAt(0, 0, 1, 0), poseAt(1, 0, 1, 0), poseAt(1, 0, 1, 0.4), poseAt(0.5, 1, 1.5, -0.3)};
  const FixedPath path(robot("cogiro"), way, 0.0);
  expectClosedAndContinuous(path, way.speed, 0.2, way.waypoints[0]);
  for (const Pose& waypoint : way.waypoints) {
    double nearest = 1e9;
    for (double time = 0.0; time < path.duration(); time += 0.01) {
      const Pose here = path.at(time);
      nearest = std::min(nearest, (here.position - waypoint.position).norm() + turn(here, waypoint));
    }
    EXPECT_LT(nearest, 0.01 * (way.speed + 0.2));
  }
  double length = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    length += (way.waypoints[(i + 1) % 4].position - way.waypoints[i].position).norm();
  }
  EXPECT_GE(path.duration(), length / way.speed + 0.4 / 0.2 - 1e-9);
}

TEST(Waypoints, ThatAreAllTheSameDoNotMove) {
  RigPath way;
  way.kind = RigPath::Kind::kWaypoints;
  way.speed = 0.25;
  way.waypoints = {poseAt(0, 0, 1, 0), poseAt(0, 0, 1, 0)};
  const FixedPath path(robot("cogiro"), way, 0.0);
  EXPECT_EQ(path.at(3.0).position, way.waypoints[0].position);
}

TEST(Target, IsReachedAtTheSpeedAndKept) {
  const Pose target = poseAt(1.0, -0.5, 2.0, 0.3);
  Pose pose = poseAt(0, 0, 1, 0);
  const double speed = 0.3, step = 0.02;
  const double time = (target.position - pose.position).norm() / speed;
  const int steps = static_cast<int>(std::ceil(time / step));
  for (int k = 0; k < steps; ++k) {
    EXPECT_GT((pose.position - target.position).norm(), 0.0) << k;
    const Pose next = stepTowards(pose, target, speed, step);
    EXPECT_LE((next.position - pose.position).norm(), speed * step * (1.0 + 1e-9));
    pose = next;
  }
  EXPECT_EQ(pose.position, target.position);
  EXPECT_LT(turn(pose, target), 1e-12);
  EXPECT_EQ(stepTowards(pose, target, speed, step).position, target.position);
}

}  // namespace
}  // namespace cdpr_kinetostatics

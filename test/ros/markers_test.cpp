// What RViz draws: every number finite, every marker with a name of its own, colours and places that mean what they
// say.

#include "ros/markers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "ros/conversions.h"
#include "ros/service_reply.h"

namespace cdpr_kinetostatics {
namespace {

using visualization_msgs::Marker;

class Markers : public testing::TestWithParam<const char*> {
 protected:
  Markers() : robot_(loadRobotFile(std::string(ROBOT_DIR) + "/" + GetParam() + ".yaml").robot) {
    InverseRequest request;
    request.pose = robot_.home;
    request.free_orientation = robot_.type == PlatformType::kRigidBody && robot_.cables.size() < 6;
    RobotSolverOptions options;
    options.model = Model::kCatenary;
    options.profile_points = 11;
    options.timeout = std::chrono::duration<double>(10.0);
    const RobotSolution solution = solveInverse(robot_, request, options);
    state_.report = toMsg(solution.report);
    state_.header.frame_id = "world";
    state_.pose.pose = toMsg(solution.pose);
    state_.cables = toMsg(solution.cables);
    state_.outlier.assign(robot_.cables.size(), 0);
  }

  std::vector<Marker> drawn(const std::string& space, int type) const {
    std::vector<Marker> found;
    for (const Marker& m : cableMarkers(robot_, state_).markers) {
      if (m.ns == space && m.type == type) found.push_back(m);
    }
    return found;
  }

  static Eigen::Vector3d at(const geometry_msgs::Point& p) { return {p.x, p.y, p.z}; }

  const RobotDescription robot_;
  KinetostaticState state_;
};

TEST_P(Markers, AreFiniteVisibleAndEachItsOwn) {
  ASSERT_EQ(state_.report.code, SolveReport::CONVERGED) << state_.report.message;
  std::set<std::pair<std::string, int>> names;
  for (const Marker& m : cableMarkers(robot_, state_).markers) {
    EXPECT_TRUE(names.insert({m.ns, m.id}).second) << m.ns << " " << m.id << " is there twice";
    EXPECT_EQ(m.header.frame_id, "world");
    EXPECT_TRUE(allFinite(m.pose));
    EXPECT_TRUE(std::isfinite(m.scale.x) && std::isfinite(m.scale.y) && std::isfinite(m.scale.z));
    EXPECT_GT(m.scale.x + m.scale.z, 0.0);
    EXPECT_TRUE(m.color.a > 0.0F || m.colors.size() == m.points.size()) << m.ns << " cannot be seen";
    for (const auto& point : m.points) EXPECT_TRUE(at(point).allFinite());
  }
}

TEST_P(Markers, CablesEndWhereTheyAreHeld) {
  const Pose pose = fromMsg(state_.pose.pose);
  for (const bool with_profiles : {true, false}) {
    if (!with_profiles) {
      for (CableState& cable : state_.cables) cable.profile.clear();
    }
    const std::vector<Marker> cables = drawn("cables", Marker::LINE_STRIP);
    ASSERT_EQ(cables.size(), robot_.cables.size());
    for (std::size_t i = 0; i < cables.size(); ++i) {
      EXPECT_EQ(cables[i].points.size(), with_profiles ? 11u : 2u);
      EXPECT_LT((at(cables[i].points.front()) - robot_.cables[i].anchor).norm(), 1e-6 * robot_.span());
      EXPECT_LT((at(cables[i].points.back()) - pose.transform(robot_.cables[i].attachment)).norm(),
                1e-6 * robot_.span());
    }
  }
}

TEST_P(Markers, ColoursTellTensionFaultsAndPush) {
  state_.cables[0].tension_a = 0.0;
  state_.cables[1].tension_a = 1e9;
  Marker low = drawn("cables", Marker::LINE_STRIP)[0], high = drawn("cables", Marker::LINE_STRIP)[1];
  EXPECT_GT(low.color.b, low.color.r);
  EXPECT_GT(high.color.r, high.color.b);
  state_.outlier[0] = 1;
  state_.cables[1].condition = CableState::COMPRESSED;
  low = drawn("cables", Marker::LINE_STRIP)[0];
  high = drawn("cables", Marker::LINE_STRIP)[1];
  EXPECT_EQ(low.color.r + low.color.b - low.color.g, 2.0F) << "magenta";
  EXPECT_EQ(high.color.r + high.color.g + high.color.b, 3.0F) << "white";
  EXPECT_NE(drawn("tensions", Marker::TEXT_VIEW_FACING)[0].text.find("outlier"), std::string::npos);
  EXPECT_EQ(drawn("tensions", Marker::TEXT_VIEW_FACING)[1].text.find("outlier"), std::string::npos);
}

TEST_P(Markers, ArrowIsWeightAndLoad) {
  const auto arrow = [&]() -> Eigen::Vector3d {
    const Marker m = drawn("load", Marker::ARROW).at(0);
    return at(m.points.at(1)) - at(m.points.at(0));
  };
  const Eigen::Vector3d weight = arrow();
  EXPECT_LT((weight.normalized() + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  state_.load.force.x = robot_.weight();
  EXPECT_LT((arrow() - weight - weight.norm() * Eigen::Vector3d::UnitX()).norm(), 1e-9 * robot_.span());
}

TEST_P(Markers, OutlineIsThatOfThePlatform) {
  const Marker box = platformMarker(robot_, state_.header, state_.pose.pose);
  const Marker outline = platformOutline(robot_, state_.header, state_.pose.pose);
  ASSERT_EQ(outline.points.size(), 24u) << "twelve edges";
  const Eigen::Vector3d half = 0.5 * Eigen::Vector3d(box.scale.x, box.scale.y, box.scale.z);
  const Pose pose = fromMsg(box.pose);
  for (std::size_t k = 0; k < outline.points.size(); k += 2) {
    for (const std::size_t end : {k, k + 1}) {
      const Eigen::Vector3d corner = pose.orientation.conjugate() * (at(outline.points[end]) - pose.position);
      EXPECT_LT((corner.cwiseAbs() - half).norm(), 1e-9 * (1.0 + half.norm()));
    }
    const Eigen::Vector3d edge = pose.orientation.conjugate() * (at(outline.points[k + 1]) - at(outline.points[k]));
    EXPECT_EQ((edge.array().abs() > 1e-9 * half.norm()).count(), 1) << "along one axis";
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Markers, testing::Values("cogiro", "scampi", "fast", "paper_point_mass"),
                         [](const auto& robot) { return robot.param; });

// Pulleys are drawn where the rope is wrapped around them, the rope from where it reaches them.
TEST(PulleyMarkers, ShowPulleyWrappedAndFreeRope) {
  RobotDescription robot = loadRobotFile(std::string(ROBOT_DIR) + "/cogiro.yaml").robot;
  robot.cables[1].properties.pulley = {0.2, RopeFrom::kAbove};
  InverseRequest request;
  request.pose = robot.home;
  RobotSolverOptions options;
  options.model = Model::kCatenary;
  options.profile_points = 11;
  options.timeout = std::chrono::duration<double>(10.0);
  const RobotSolution solution = solveInverse(robot, request, options);
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  KinetostaticState state;
  state.pose.pose = toMsg(solution.pose);
  state.cables = toMsg(solution.cables);
  state.outlier.assign(robot.cables.size(), 0);
  int circles = 0;
  for (const Marker& m : cableMarkers(robot, state).markers) {
    const auto at = [](const geometry_msgs::Point& p) { return Eigen::Vector3d(p.x, p.y, p.z); };
    if (m.ns == "pulleys") {
      ++circles;
      EXPECT_EQ(m.id, 1);
      EXPECT_LT((at(m.points[0]) - robot.cables[1].anchor).norm(), 1e-12);
      for (const auto& p : m.points) {
        const Eigen::Vector3d centre = robot.cables[1].anchor + 0.2 * solution.cables[1].direction;
        EXPECT_NEAR((at(p) - centre).norm(), 0.2, 1e-12);
      }
    }
    if (m.ns == "cables" && m.id == 1) {
      ASSERT_EQ(m.points.size(), 12u + 11u);
      EXPECT_LT((at(m.points[0]) - robot.cables[1].anchor).norm(), 1e-12);
      EXPECT_LT((at(m.points[12]) - solution.cables[1].departure).norm(), 1e-12);
      // The wrapped part goes on into the free one without a corner: steps of the arc alone.
      EXPECT_LT((at(m.points[11]) - at(m.points[12])).norm(), 1.01 * 0.2 * state.cables[1].wrap_angle / 12);
      EXPECT_LT(at(m.points[6]).z(), robot.cables[1].anchor.z()) << "under the bottom";
    }
  }
  EXPECT_EQ(circles, 1);
}

}  // namespace
}  // namespace cdpr_kinetostatics

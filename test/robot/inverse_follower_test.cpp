// Following a path gives the answers of cold inverse solves; what cannot be followed is solved cold.
#include "cdpr_kinetostatics/robot/inverse_follower.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-9;

std::vector<double> preferredAt(const RobotDescription& robot, double share) {
  std::vector<double> preferred;
  for (const CableDescription& cable : robot.cables) {
    preferred.push_back(cable.tension_min + share * (cable.tension_max - cable.tension_min));
  }
  return preferred;
}

std::vector<Model> rungsOf(const RobotSolution& solution) {
  std::vector<Model> rungs;
  for (const CableResult& cable : solution.cables) rungs.push_back(cable.cable.model);
  return rungs;
}

void expectSame(const RobotSolution& followed, const RobotSolution& cold) {
  ASSERT_EQ(rungsOf(followed), rungsOf(cold));
  EXPECT_TRUE(samePose(followed.pose, cold.pose, 1e-12));
  for (std::size_t i = 0; i < cold.cables.size(); ++i) {
    const CableSolution& a = followed.cables[i].cable;
    const CableSolution& b = cold.cables[i].cable;
    EXPECT_NEAR(a.length, b.length, 100.0 * kTolerance * b.length) << i;
    EXPECT_NEAR(a.tension_a, b.tension_a, 100.0 * kTolerance * b.tension_a) << i;
    EXPECT_EQ(followed.cables[i].condition, cold.cables[i].condition) << i;
  }
}

class InverseFollowing : public testing::TestWithParam<std::tuple<Workspace, Model>> {
 protected:
  const Workspace workspace_ = std::get<0>(GetParam());
  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, workspace_.robot);
  const RobotSolverOptions options_ = patient(std::get<1>(GetParam()), kTolerance);

  // Along a line through the workspace in steps [m]; returns how many solves were warm. Tensions near their middle, and
  // preferred so low that limits are reached.
  int follow(double step, double share) const {
    const Eigen::Vector3d way = 0.6 * (workspace_.high - workspace_.low);
    const int steps = std::max(2, std::min(12, static_cast<int>(way.norm() / step)));
    InverseFollower follower(robot_, options_);
    int warm = 0;
    for (int i = 0; i <= steps; ++i) {
      SCOPED_TRACE(i);
      Pose pose;
      pose.position = 0.5 * (workspace_.low + workspace_.high) - 0.5 * way + i * step * way.normalized();
      InverseRequest request = requestFor(robot_, pose);
      request.preferred_tensions = preferredAt(robot_, share);
      const RobotSolution cold = solveInverse(robot_, request, options_);
      const Status& status = follower.solve(request);
      EXPECT_EQ(status.code, cold.report.status.code) << status.message;
      const RobotSolution followed = follower.solution();
      EXPECT_EQ(followed.report.status.code, status.code);
      if (!follower.warmStarted()) {
        EXPECT_EQ(followed.report.status.message, cold.report.status.message);
        EXPECT_EQ(lengthsOf(followed), lengthsOf(cold));
      }
      if (!status.ok() || !cold.report.status.ok()) continue;
      warm += follower.warmStarted() ? 1 : 0;
      if (rungsOf(followed) == rungsOf(cold)) {
        expectSame(followed, cold);
      } else {  // AUTO has kept rungs that are finer than need be
        EXPECT_EQ(options_.model, Model::kAuto);
        EXPECT_TRUE(follower.warmStarted() && followed.report.error_known);
        EXPECT_LT(followed.report.estimated_error, options_.accuracy);
      }
    }
    return warm;
  }
};

TEST_P(InverseFollowing, GivesColdAnswersInSmallSteps) {
  const int warm = follow(0.01, 0.5);
  EXPECT_TRUE(warm == 12 || workspace_.robot != "cogiro") << warm;
}

TEST_P(InverseFollowing, GivesColdAnswersInLongSteps) { follow(0.2, 0.5); }

TEST_P(InverseFollowing, GivesColdAnswersAtLimits) {
  follow(0.01, 0.0);
  follow(0.01, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, InverseFollowing,
                         testing::Combine(testing::ValuesIn(shippedWorkspaces()),
                                          testing::Values(Model::kStraightElastic, Model::kCatenary,
                                                          Model::kCatenaryCorrected, Model::kBending, Model::kAuto)),
                         [](const auto& each) {
                           return std::get<0>(each.param).robot + "_" + modelName(std::get<1>(each.param));
                         });

class InverseFollowingCogiro : public testing::Test {
 protected:
  InverseRequest requestAt(const Eigen::Vector3d& position) const {
    Pose pose;
    pose.position = position;
    return requestFor(robot_, pose);
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  const RobotSolverOptions options_ = patient(Model::kCatenary, kTolerance);
  InverseFollower follower_{robot_, options_};
};

// Every step moves the preferred tensions as well, so that limits are reached and left on the way.
TEST_F(InverseFollowingCogiro, LoadsAndPreferencesMayChange) {
  Dice dice(73);
  int warm = 0;
  int changes = 0;
  std::vector<bool> last;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    InverseRequest request = requestAt({0.005 * i, 0.0, 1.5});
    request.external_wrench << 2.0 * i, -3.0 * i, -10.0 * i, 1.0 * i, 0.5 * i, 0.0;
    const double phase = 0.1 * i;
    for (std::size_t k = 0; k < robot_.cables.size(); ++k) {
      const CableDescription& cable = robot_.cables[k];
      request.preferred_tensions.push_back(cable.tension_min +
                                           (cable.tension_max - cable.tension_min) *
                                               (0.5 + 0.45 * std::sin(phase + static_cast<double>(k * k))));
    }
    const RobotSolution cold = solveInverse(robot_, request, options_);
    ASSERT_EQ(follower_.solve(request).code, cold.report.status.code) << cold.report.status.message;
    if (!cold.report.status.ok()) continue;
    expectSame(follower_.solution(), cold);
    warm += follower_.warmStarted() ? 1 : 0;
    std::vector<bool> limited;
    for (std::size_t k = 0; k < robot_.cables.size(); ++k) {
      const double tension = cold.cables[k].cable.tension_a;
      limited.push_back(tension < robot_.cables[k].tension_min * (1.0 + 1e-6) ||
                        tension > robot_.cables[k].tension_max * (1.0 - 1e-6));
    }
    changes += !last.empty() && limited != last ? 1 : 0;
    last = limited;
  }
  EXPECT_GT(warm, 30);
  EXPECT_GT(changes, 0);
}

TEST_F(InverseFollowingCogiro, AJumpIsSolvedAsExactly) {
  ASSERT_TRUE(follower_.solve(requestAt({-1.5, -1.0, 1.0})).ok());
  const InverseRequest far = requestAt({1.5, 1.0, 2.0});
  ASSERT_TRUE(follower_.solve(far).ok());
  expectSame(follower_.solution(), solveInverse(robot_, far, options_));
}

TEST_F(InverseFollowingCogiro, AFreeAttitudeIsSolvedCold) {
  InverseRequest request = requestAt({0.0, 0.0, 1.5});
  ASSERT_TRUE(follower_.solve(request).ok());
  request.free_orientation = true;
  ASSERT_TRUE(follower_.solve(request).ok());
  EXPECT_FALSE(follower_.warmStarted());
  request.free_orientation = false;
  ASSERT_TRUE(follower_.solve(request).ok());
  expectSame(follower_.solution(), solveInverse(robot_, request, options_));
}

TEST_F(InverseFollowingCogiro, RecoversFromRequestsThatCannotBeServed) {
  const InverseRequest good = requestAt({0.0, 0.0, 1.5});
  InverseRequest nowhere = good;
  nowhere.pose.position.x() = std::numeric_limits<double>::quiet_NaN();
  InverseRequest outside = good;
  outside.pose.position.x() = 50.0;
  InverseRequest heavy = good;
  heavy.external_wrench.z() = -1e9;
  for (const InverseRequest& bad : {nowhere, outside, heavy}) {
    ASSERT_TRUE(follower_.solve(good).ok());
    const RobotSolution cold = solveInverse(robot_, bad, options_);
    EXPECT_FALSE(cold.report.status.ok());
    EXPECT_EQ(follower_.solve(bad).code, cold.report.status.code);
    EXPECT_FALSE(follower_.warmStarted());
    EXPECT_EQ(follower_.solution().report.status.message, cold.report.status.message);
    ASSERT_TRUE(follower_.solve(good).ok());
    EXPECT_FALSE(follower_.warmStarted());
  }
}

TEST_F(InverseFollowingCogiro, LengthsAndTensionsAreThoseOfTheSolution) {
  for (const double x : {0.0, 0.005}) {
    ASSERT_TRUE(follower_.solve(requestAt({x, 0.0, 1.5})).ok());
    EXPECT_EQ(follower_.warmStarted(), x > 0.0);
    const RobotSolution solution = follower_.solution();
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      EXPECT_EQ(follower_.length(i), solution.cables[i].cable.length);
      EXPECT_NEAR(follower_.tension(i), solution.cables[i].cable.tension_a, 1e-9);
    }
  }
}

TEST_F(InverseFollowingCogiro, ForgettingMakesTheNextSolveCold) {
  const InverseRequest request = requestAt({0.0, 0.0, 1.5});
  ASSERT_TRUE(follower_.solve(request).ok());
  ASSERT_TRUE(follower_.solve(request).ok());
  EXPECT_TRUE(follower_.warmStarted());
  follower_.forget();
  ASSERT_TRUE(follower_.solve(request).ok());
  EXPECT_FALSE(follower_.warmStarted());
}

}  // namespace
}  // namespace cdpr_kinetostatics

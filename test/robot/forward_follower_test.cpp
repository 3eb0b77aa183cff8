// Following a path gives the answers of cold solves; what cannot be followed is solved cold.
#include "cdpr_kinetostatics/robot/forward_follower.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-8;

class FollowingEveryRung : public testing::TestWithParam<std::tuple<Workspace, Model>> {
 protected:
  const Workspace workspace_ = std::get<0>(GetParam());
  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, workspace_.robot);
  const RobotSolverOptions options_ = patient(std::get<1>(GetParam()), kTolerance);

  // Lengths for poses on a line through the workspace, so far apart [m]; poses out of the rung's reach are left out.
  std::vector<ForwardRequest> pathOf(double distance, int count) const {
    std::vector<ForwardRequest> path;
    const Eigen::Vector3d way = 0.6 * (workspace_.high - workspace_.low);
    const int most = std::max(1, std::min(count, static_cast<int>(way.norm() / distance)));
    for (int i = 0; i <= most; ++i) {
      Pose pose;
      pose.position = 0.5 * (workspace_.low + workspace_.high) - 0.5 * way + i * distance * way.normalized();
      const RobotSolution inverse = solveInverse(robot_, requestFor(robot_, pose), options_);
      if (!inverse.report.status.ok()) continue;
      ForwardRequest request;
      request.lengths = lengthsOf(inverse);
      request.seed = inverse.pose;
      path.push_back(request);
    }
    return path;
  }

  // Returns how many of the path's solves were warm.
  int expectColdAnswers(const std::vector<ForwardRequest>& path) const {
    ForwardFollower follower(robot_, options_);
    int warm = 0;
    for (const ForwardRequest& request : path) {
      const RobotSolution cold = solveForward(robot_, request, options_);
      const Status& status = follower.solve(request);
      EXPECT_EQ(status.code, cold.report.status.code) << status.message;
      if (!cold.report.status.ok() || !status.ok()) continue;
      warm += follower.warmStarted() ? 1 : 0;
      const RobotSolution followed = follower.solution();
      EXPECT_LT((followed.pose.position - cold.pose.position).norm(), kTolerance * robot_.span());
      EXPECT_LT(followed.pose.orientation.angularDistance(cold.pose.orientation), 10.0 * kTolerance);
      for (std::size_t i = 0; i < cold.cables.size(); ++i) {
        const double tension = cold.cables[i].cable.tension_a;
        EXPECT_NEAR(followed.cables[i].cable.tension_a, tension, 2.0 * kTolerance * tension + 1e-9 * robot_.weight());
        EXPECT_EQ(followed.cables[i].cable.model, cold.cables[i].cable.model);
        EXPECT_EQ(followed.cables[i].condition, cold.cables[i].condition);
      }
    }
    return warm;
  }
};

TEST_P(FollowingEveryRung, GivesColdAnswersInSmallSteps) {
  const std::vector<ForwardRequest> path = pathOf(0.01, 12);
  const int warm = expectColdAnswers(path);
  // Where cables hardly stretch, 10 mm may change forces beyond what can be followed.
  if (!isInextensible(options_.model) && !isStraight(options_.model) && robot_.span() > 3.0) {
    EXPECT_EQ(warm, std::max(0, static_cast<int>(path.size()) - 1));
  }
}

TEST_P(FollowingEveryRung, GivesColdAnswersInLongSteps) { expectColdAnswers(pathOf(0.2, 8)); }

std::string nameOf(const testing::TestParamInfo<std::tuple<Workspace, Model>>& info) {
  return std::get<0>(info.param).robot + "_" + modelName(std::get<1>(info.param));
}

INSTANTIATE_TEST_SUITE_P(Shipped, FollowingEveryRung,
                         testing::Combine(testing::ValuesIn(shippedWorkspaces()),
                                          testing::Values(Model::kStraightElastic, Model::kCatenaryInextensible,
                                                          Model::kCatenary, Model::kCatenaryCorrected,
                                                          Model::kBendingInextensible, Model::kBending)),
                         nameOf);

class Following : public testing::Test {
 protected:
  ForwardRequest requestAt(const Eigen::Vector3d& position) const {
    Pose pose;
    pose.position = position;
    const RobotSolution inverse = solveInverse(robot_, requestFor(robot_, pose), options_);
    EXPECT_TRUE(inverse.report.status.ok());
    ForwardRequest request;
    request.lengths = lengthsOf(inverse);
    return request;
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  RobotSolverOptions options_ = patient(Model::kBending, kTolerance);
};

// 10 mm turn the short wires of the desktop robot by some hundredths of a radian, and stiff wires forgive no error of
// second order in that.
TEST_F(Following, ShortStiffCablesTakeTwoLinearisations) {
  const RobotDescription desktop = shippedRobot(ROBOT_DIR, "desktop_music_wire");
  ForwardFollower follower(desktop, options_);
  for (int i = 0; i <= 10; ++i) {
    Pose pose = desktop.home;
    pose.position += Eigen::Vector3d(0.01 * (i - 5), 0.004 * (i - 5), 0.0);
    const RobotSolution inverse = solveInverse(desktop, requestFor(desktop, pose), options_);
    ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    ForwardRequest request;
    request.lengths = lengthsOf(inverse);
    request.seed = pose;
    ASSERT_TRUE(follower.solve(request).ok());
    EXPECT_TRUE(follower.warmStarted() || i == 0) << i;
    EXPECT_TRUE(follower.iterations() <= 2 || i == 0) << i << ": " << follower.iterations();
    const RobotReport report = follower.solution().report;
    EXPECT_GT(report.integrator_steps, 0);
    EXPECT_LT(report.integrator_steps, 3000) << "of this solve alone";
  }
}

TEST_F(Following, LoadsMayChange) {
  ForwardRequest request = requestAt({0.0, 0.0, 1.5});
  ForwardFollower follower(robot_, options_);
  ASSERT_TRUE(follower.solve(request).ok());
  EXPECT_FALSE(follower.warmStarted());
  for (int i = 1; i <= 5; ++i) {
    request.external_wrench << 5.0 * i, -3.0 * i, -20.0 * i, 1.0 * i, 0.5 * i, 0.0;
    ASSERT_TRUE(follower.solve(request).ok());
    EXPECT_TRUE(follower.warmStarted());
    const RobotSolution cold = solveForward(robot_, request, options_);
    ASSERT_TRUE(cold.report.status.ok());
    EXPECT_TRUE(samePose(follower.pose(), cold.pose, 1e-7));
  }
}

TEST_F(Following, AJumpIsSolvedCold) {
  ForwardFollower follower(robot_, options_);
  ASSERT_TRUE(follower.solve(requestAt({-1.5, -1.0, 1.0})).ok());
  const ForwardRequest far = requestAt({1.5, 1.0, 2.0});
  ASSERT_TRUE(follower.solve(far).ok());
  EXPECT_FALSE(follower.warmStarted());
  EXPECT_TRUE(samePose(follower.pose(), solveForward(robot_, far, options_).pose, 1e-9));
}

TEST_F(Following, RecoversFromRequestsThatCannotBeServed) {
  const ForwardRequest good = requestAt({0.0, 0.0, 1.5});
  ForwardFollower follower(robot_, options_);
  for (const double length : {std::numeric_limits<double>::quiet_NaN(), -1.0, 0.0, 1e9}) {
    ASSERT_TRUE(follower.solve(good).ok());
    ForwardRequest bad = good;
    bad.lengths[3] = length;
    EXPECT_EQ(follower.solve(bad).code, Code::kInvalidInput);
    EXPECT_FALSE(follower.warmStarted());
    EXPECT_EQ(follower.solution().report.status.code, Code::kInvalidInput);
    ASSERT_TRUE(follower.solve(good).ok());
    EXPECT_FALSE(follower.warmStarted());
  }
  ForwardRequest few = good;
  few.lengths.pop_back();
  EXPECT_EQ(follower.solve(few).code, Code::kInvalidInput);
}

TEST_F(Following, AColdStartCostsWhatAColdSolveCosts) {
  const ForwardRequest request = requestAt({0.0, 0.0, 1.5});
  for (const Model model :
       {Model::kStraight, Model::kStraightElastic, Model::kCatenary, Model::kBending, Model::kAuto}) {
    const RobotSolverOptions options = patient(model, kTolerance);
    const RobotSolution cold = solveForward(robot_, request, options);
    ForwardFollower follower(robot_, options);
    ASSERT_EQ(follower.solve(request).code, cold.report.status.code);
    EXPECT_EQ(follower.iterations(), cold.report.iterations) << modelName(model);
    EXPECT_EQ(follower.pose().position, cold.pose.position) << modelName(model);
    EXPECT_EQ(tensionsOf(follower.solution()), tensionsOf(cold)) << modelName(model);
    EXPECT_EQ(follower.solution().report.status.message, cold.report.status.message);
  }
}

TEST_F(Following, AColdStartObeysTheDeadline) {
  const ForwardRequest request = requestAt({0.0, 0.0, 1.5});
  options_.timeout = std::chrono::duration<double>(1e-9);
  ForwardFollower follower(robot_, options_);
  EXPECT_EQ(follower.solve(request).code, Code::kTimedOut);
  EXPECT_EQ(follower.solution().report.status.code, Code::kTimedOut);
}

TEST_F(Following, PoseLengthsAndTensionsAreThoseOfTheSolution) {
  for (const Model model :
       {Model::kStraight, Model::kStraightElastic, Model::kCatenary, Model::kBending, Model::kAuto}) {
    SCOPED_TRACE(modelName(model));
    const RobotSolverOptions options = patient(model, kTolerance);
    ForwardFollower follower(robot_, options);
    for (const double x : {0.0, 0.005}) {
      const ForwardRequest request = requestAt({x, 0.0, 1.5});
      if (!follower.solve(request).ok()) continue;
      const RobotSolution solution = follower.solution();
      EXPECT_EQ(follower.pose().position, solution.pose.position);
      EXPECT_EQ(follower.iterations(), solution.report.iterations);
      for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
        const double tension = solution.cables[i].cable.tension_a;
        EXPECT_NEAR(follower.length(i), request.lengths[i], 1e-15 * request.lengths[i]);
        EXPECT_NEAR(follower.tension(i), tension, 1e-9 * tension);
      }
    }
  }
}

TEST_F(Following, ForgettingMakesTheNextSolveCold) {
  const ForwardRequest request = requestAt({0.0, 0.0, 1.5});
  ForwardFollower follower(robot_, options_);
  ASSERT_TRUE(follower.solve(request).ok());
  follower.forget();
  ASSERT_TRUE(follower.solve(request).ok());
  EXPECT_FALSE(follower.warmStarted());
}

TEST_F(Following, StiffnessIsThatOfTheColdSolve) {
  options_.compute_stiffness = true;
  ForwardFollower follower(robot_, options_);
  ASSERT_TRUE(follower.solve(requestAt({0.0, 0.0, 1.5})).ok());
  const ForwardRequest next = requestAt({0.01, 0.0, 1.5});
  ASSERT_TRUE(follower.solve(next).ok());
  ASSERT_TRUE(follower.warmStarted());
  const RobotSolution cold = solveForward(robot_, next, options_);
  EXPECT_LT((follower.solution().stiffness - cold.stiffness).norm(), 1e-4 * cold.stiffness.norm());
}

}  // namespace
}  // namespace cdpr_kinetostatics

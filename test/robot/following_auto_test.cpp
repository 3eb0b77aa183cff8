// Following a path by AUTO: as accurate as asked for, by the rungs that the report names.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "cdpr_kinetostatics/robot/forward_follower.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-8;
constexpr double kStep = 0.01;  // [m]

std::vector<Model> rungsOf(const RobotSolution& solution) {
  std::vector<Model> rungs;
  for (const CableResult& cable : solution.cables) rungs.push_back(cable.cable.model);
  return rungs;
}

class FollowingByAuto : public testing::TestWithParam<std::tuple<Workspace, double>> {
 protected:
  const Workspace workspace_ = std::get<0>(GetParam());
  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, workspace_.robot);
  const double accuracy_ = std::get<1>(GetParam());
};

TEST_P(FollowingByAuto, IsAsAccurateAsTheColdSolve) {
  RobotSolverOptions options = patient(Model::kAuto, kTolerance);
  options.accuracy = accuracy_;
  ForwardFollower follower(robot_, options);
  const Eigen::Vector3d way = (workspace_.high - workspace_.low).normalized();
  std::vector<Model> last;
  int warm = 0;
  for (int i = 0; i <= 12; ++i) {
    SCOPED_TRACE(i);
    Pose pose;
    pose.position = 0.5 * (workspace_.low + workspace_.high) + i * kStep * way;
    const RobotSolution inverse = solveInverse(robot_, requestFor(robot_, pose), patient(Model::kBending, 1e-10));
    if (!inverse.report.status.ok()) continue;
    ForwardRequest request;
    request.lengths = lengthsOf(inverse);
    request.seed = inverse.pose;

    const RobotSolution cold = solveForward(robot_, request, options);
    const Status& status = follower.solve(request);
    ASSERT_EQ(status.code, cold.report.status.code) << status.message;
    if (!status.ok()) continue;
    const RobotSolution followed = follower.solution();
    EXPECT_LT((followed.pose.position - inverse.pose.position).norm(), accuracy_ + 1e-7);
    EXPECT_TRUE(followed.report.error_known);
    EXPECT_LT(followed.report.estimated_error, accuracy_);
    EXPECT_GT(followed.report.solve_time, 0.0);
    const std::vector<Model> rungs = rungsOf(followed);
    const std::string finest = modelName(*std::max_element(rungs.begin(), rungs.end()));
    EXPECT_NE(followed.report.status.message.find(finest), std::string::npos) << followed.report.status.message;
    if (rungs == rungsOf(cold)) {
      EXPECT_LT((followed.pose.position - cold.pose.position).norm(), 2.0 * kTolerance * robot_.span());
      EXPECT_EQ(followed.report.status.message.substr(0, followed.report.status.message.find(';')),
                cold.report.status.message.substr(0, cold.report.status.message.find(';')));
    }
    EXPECT_TRUE(rungs == last || !follower.warmStarted()) << "a change of rungs is a cold start";
    warm += follower.warmStarted() ? 1 : 0;
    last = rungs;
  }
  const bool lines = !last.empty() && isStraight(*std::max_element(last.begin(), last.end()));
  // Rungs finer than needed go on; lines hold only where they hold with some to spare.
  EXPECT_GE(warm, lines ? 0 : 9) << workspace_.robot;
}

std::string nameOf(const testing::TestParamInfo<std::tuple<Workspace, double>>& info) {
  const double accuracy = std::get<1>(info.param);
  return std::get<0>(info.param).robot + (accuracy > 5e-3 ? "_1cm" : accuracy > 5e-5 ? "_100um" : "_1um");
}

INSTANTIATE_TEST_SUITE_P(Shipped, FollowingByAuto,
                         testing::Combine(testing::ValuesIn(shippedWorkspaces()), testing::Values(1e-2, 1e-4, 1e-6)),
                         nameOf);

// Bending tells the more the less a cable is tightened: the rungs must follow.
TEST(FollowingByAuto, GivesUpRungsThatNoLongerServe) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  RobotSolverOptions options = patient(Model::kAuto, 1e-10);
  options.accuracy = 1e-7;
  Pose pose;
  pose.position = {0.0, 0.0, 1.5};
  InverseRequest inverse = requestFor(robot, pose);
  ForwardFollower follower(robot, options);
  std::vector<std::vector<Model>> used;
  for (int i = 0; i <= 30; ++i) {
    inverse.preferred_tensions.assign(robot.cables.size(), 2000.0 - 60.0 * i);
    const RobotSolution at = solveInverse(robot, inverse, patient(Model::kBending, 1e-10));
    ASSERT_TRUE(at.report.status.ok()) << at.report.status.message;
    ForwardRequest request;
    request.lengths = lengthsOf(at);
    request.seed = at.pose;
    ASSERT_TRUE(follower.solve(request).ok());
    EXPECT_LT((follower.pose().position - pose.position).norm(), options.accuracy);
    const std::vector<Model> rungs = rungsOf(follower.solution());
    if (used.empty() || rungs != used.back()) {
      EXPECT_FALSE(follower.warmStarted());
      used.push_back(rungs);
    }
  }
  EXPECT_GT(used.size(), 1u);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The inverse solver's memory: what it says when it fails, and that a path leaves no trace in a cold solve.
#include "robot/inverse_solve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <string>

#include "cable/input_limits.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = InverseSolve::Clock;

class InverseSolveOfCogiro : public testing::TestWithParam<Model> {
 protected:
  InverseRequest requestAt(const Eigen::Vector3d& position) const {
    Pose pose;
    pose.position = position;
    return requestFor(robot_, pose);
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  const RobotSolverOptions options_ = patient(GetParam(), 1e-9);
  InverseSolve solve_{robot_, options_};
};

TEST_P(InverseSolveOfCogiro, AColdSolveDependsOnItsRequestAlone) {
  const InverseRequest request = requestAt({0.5, 0.3, 1.2});
  const RobotSolution first = solveInverse(robot_, request, options_);
  ASSERT_TRUE(solve_.solve(requestAt({0.0, 0.0, 1.5}), Clock::time_point::max()).ok());
  ASSERT_TRUE(solve_.follow(requestAt({0.01, 0.0, 1.5})));
  ASSERT_TRUE(solve_.solve(request, Clock::time_point::max()).ok());
  EXPECT_EQ(lengthsOf(solve_.solution()), lengthsOf(first));
  EXPECT_EQ(solve_.iterations(), first.report.iterations);
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    EXPECT_EQ(solve_.length(i), first.cables[i].cable.length);
    EXPECT_NEAR(solve_.tension(i), first.cables[i].cable.tension_a, 1e-9);
  }
}

TEST_P(InverseSolveOfCogiro, AFailureReportsWhatItHadReached) {
  InverseRequest heavy = requestAt({0.0, 0.0, 1.5});
  heavy.external_wrench.z() = -1e5;
  EXPECT_EQ(solve_.solve(heavy, Clock::time_point::max()).code, Code::kInfeasible);
  const RobotSolution refused = solve_.solution();
  EXPECT_EQ(refused.report.status.code, Code::kInfeasible);
  EXPECT_TRUE(refused.cables.empty());
  EXPECT_GT(refused.report.iterations, 0);
  EXPECT_EQ(refused.report.iterations, solve_.iterations());
  EXPECT_TRUE(isFinite(refused));
  // What the cables cannot carry at their limits: at least the load less all that eight cables can pull.
  double most = 0.0;
  for (const CableDescription& cable : robot_.cables) most += cable.tension_max;
  EXPECT_GT(refused.report.force_residual, 1e5 - 1.5 * most);
  EXPECT_LT(refused.report.force_residual, 1e5 + 1.5 * most);
}

TEST_P(InverseSolveOfCogiro, NoTimeMeansNoIteration) {
  const Status& status = solve_.solve(requestAt({0.0, 0.0, 1.5}), Clock::now() - std::chrono::seconds(1));
  EXPECT_EQ(status.code, Code::kTimedOut);
  EXPECT_EQ(solve_.solution().report.iterations, 0);
}

TEST_P(InverseSolveOfCogiro, DoesNotFollowWhereItCannot) {
  ASSERT_TRUE(solve_.solve(requestAt({0.0, 0.0, 1.5}), Clock::time_point::max()).ok());
  InverseRequest free = requestAt({0.0, 0.0, 1.5});
  free.free_orientation = true;
  EXPECT_FALSE(solve_.follow(free));
  ASSERT_TRUE(solve_.solve(requestAt({0.0, 0.0, 1.5}), Clock::time_point::max()).ok());
  EXPECT_FALSE(solve_.follow(requestAt({12.0, 0.0, 1.5}))) << "outside the frame";
}

// As many cables as a description may have, half of them asked to pull as hard as they can.
TEST(InverseSolveOfManyCables, KeepsToItsTime) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  CableDescription cable = robot.cables[0];
  robot.cables.clear();
  InverseRequest request;
  request.pose.position = {0.3, 0.2, 1.5};
  for (std::size_t i = 0; i < kMostCables; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(kMostCables);
    cable.name = "cable" + std::to_string(i);
    cable.anchor = {6.0 * std::cos(angle), 5.0 * std::sin(angle), i % 2 == 0 ? 5.0 : -1.0};
    cable.attachment = {0.5 * std::cos(angle + 0.5), 0.5 * std::sin(angle + 0.5), 0.1 * static_cast<double>(i % 3)};
    robot.cables.push_back(cable);
    request.preferred_tensions.push_back(i % 2 == 0 ? cable.tension_min : cable.tension_max);
  }
  RobotSolverOptions options = patient(Model::kCatenary);
  options.timeout = std::chrono::milliseconds(50);
  const std::clock_t begin = std::clock();
  const RobotSolution solution = solveInverse(robot, request, options);
  // Of this process' own time, so that a busy machine does not count; one decomposition more is what may be late.
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 0.5);
  EXPECT_TRUE(solution.report.status.ok() || solution.report.status.code == Code::kTimedOut)
      << solution.report.status.message;
}

INSTANTIATE_TEST_SUITE_P(Models, InverseSolveOfCogiro, testing::Values(Model::kCatenary, Model::kBending, Model::kAuto),
                         [](const auto& model) { return std::string(modelName(model.param)); });

}  // namespace
}  // namespace cdpr_kinetostatics

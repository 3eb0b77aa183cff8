// The forward solver's memory: a path leaves no trace in a cold solve, and a failure says what it had reached.
#include "robot/forward_solve.h"

#include <gtest/gtest.h>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = ForwardSolve::Clock;

class ForwardSolveOfCogiro : public testing::TestWithParam<Model> {
 protected:
  ForwardRequest requestAt(const Eigen::Vector3d& position) const {
    Pose pose;
    pose.position = position;
    const RobotSolution inverse = solveInverse(robot_, requestFor(robot_, pose), patient(Model::kBending, 1e-9));
    EXPECT_TRUE(inverse.report.status.ok());
    ForwardRequest request;
    request.lengths = lengthsOf(inverse);
    return request;
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  const RobotSolverOptions options_ = patient(GetParam(), 1e-9);
  ForwardSolve solve_{robot_, options_};
};

TEST_P(ForwardSolveOfCogiro, AColdSolveDependsOnItsRequestAlone) {
  const ForwardRequest request = requestAt({0.5, 0.3, 1.2});
  const RobotSolution first = solveForward(robot_, request, options_);
  ASSERT_TRUE(first.report.status.ok()) << first.report.status.message;
  ASSERT_TRUE(solve_.solve(requestAt({0.0, 0.0, 1.5}), Clock::time_point::max()).ok());
  solve_.follow(requestAt({0.001, 0.0, 1.5}));
  const Status status = solve_.solve(request, Clock::time_point::max());
  ASSERT_TRUE(status.ok());
  const RobotSolution second = solve_.solution();
  EXPECT_EQ(status.message, first.report.status.message);
  EXPECT_EQ(second.report.status.message, first.report.status.message);
  EXPECT_EQ(second.report.iterations, first.report.iterations);
  EXPECT_EQ(second.pose.position, first.pose.position);
  EXPECT_EQ(tensionsOf(second), tensionsOf(first));
  EXPECT_EQ(solve_.pose().position, first.pose.position);
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    EXPECT_EQ(solve_.length(i), request.lengths[i]);
    EXPECT_NEAR(solve_.tension(i), first.cables[i].cable.tension_a, 1e-12 * first.cables[i].cable.tension_a);
  }
}

// A path goes on from the very state of the cold solve: nothing is solved twice.
TEST_P(ForwardSolveOfCogiro, APathGoesOnFromAColdSolve) {
  if (isStraight(GetParam())) GTEST_SKIP() << "lines are slack at some poses";
  const ForwardRequest request = requestAt({0.0, 0.0, 1.5});
  ASSERT_TRUE(solve_.solve(request, Clock::time_point::max()).ok());
  const Pose cold = solve_.pose();
  const int cold_iterations = solve_.iterations();
  EXPECT_GT(cold_iterations, 2);
  ASSERT_TRUE(solve_.follow(request));
  EXPECT_LE(solve_.iterations(), 2);
  EXPECT_TRUE(samePose(solve_.pose(), cold, 1e-9 * robot_.span()));
  ASSERT_TRUE(solve_.follow(requestAt({0.01, 0.0, 1.5})));
  EXPECT_EQ(solve_.solution().report.iterations, solve_.iterations());
}

TEST_P(ForwardSolveOfCogiro, NoTimeMeansNoIterationButTheSeedsResiduals) {
  const Status& status = solve_.solve(requestAt({0.0, 0.0, 1.5}), Clock::now() - std::chrono::seconds(1));
  EXPECT_EQ(status.code, Code::kTimedOut);
  const RobotSolution refused = solve_.solution();
  EXPECT_EQ(refused.report.iterations, 0);
  EXPECT_TRUE(isFinite(refused));
}

INSTANTIATE_TEST_SUITE_P(Models, ForwardSolveOfCogiro,
                         testing::Values(Model::kStraight, Model::kStraightElastic, Model::kCatenary, Model::kBending,
                                         Model::kAuto),
                         [](const auto& model) { return std::string(modelName(model.param)); });

// Inextensible cables that do not reach across the frame: the springs find a pose, the catenaries cannot.
TEST(ForwardSolve, AFailureReportsWhatItHadReached) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  for (const Model model : {Model::kCatenaryInextensible, Model::kBendingInextensible}) {
    SCOPED_TRACE(modelName(model));
    ForwardSolve solve(robot, patient(model));
    ForwardRequest request;
    request.lengths.assign(8, 0.5);
    const Status status = solve.solve(request, Clock::time_point::max());
    ASSERT_FALSE(status.ok());
    const RobotSolution refused = solve.solution();
    EXPECT_EQ(refused.report.status.code, status.code);
    EXPECT_EQ(refused.report.status.message, status.message);
    EXPECT_TRUE(refused.cables.empty());
    EXPECT_GT(refused.report.iterations, 0);
    // Eight ends cannot all be within half a metre of anchors that are metres apart.
    EXPECT_GT(refused.report.closure_residual, 1.0);
    EXPECT_TRUE(isFinite(refused));
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

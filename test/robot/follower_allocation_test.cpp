// Following a path takes nothing from the heap once the path has been followed before.
#include <gtest/gtest.h>

#include <vector>

#include "cdpr_kinetostatics/robot/forward_follower.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "counted_allocations.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

class FollowerAllocation : public testing::TestWithParam<Model> {
 protected:
  // There and back again through CoGiRo's workspace, in steps of 10 mm.
  std::vector<Pose> path() const {
    std::vector<Pose> poses;
    for (int i = 0; i < 40; ++i) {
      Pose pose;
      pose.position = {0.01 * (i < 20 ? i : 40 - i), 0.0, 1.5};
      poses.push_back(pose);
    }
    return poses;
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  const RobotSolverOptions options_ = patient(GetParam());
};

TEST_P(FollowerAllocation, AForwardSolveTakesNothing) {
  std::vector<ForwardRequest> requests;
  for (const Pose& pose : path()) {
    const RobotSolution inverse = solveInverse(robot_, requestFor(robot_, pose), options_);
    ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    ForwardRequest request;
    request.lengths = lengthsOf(inverse);
    requests.push_back(request);
  }
  ForwardFollower follower(robot_, options_);
  for (int round = 0; round < 2; ++round) {
    const long allocations = heapCount().allocations;
    for (const ForwardRequest& request : requests) {
      ASSERT_TRUE(follower.solve(request).ok());
      ASSERT_TRUE(follower.warmStarted() || round == 0);
    }
    EXPECT_TRUE(heapCount().allocations == allocations || round == 0) << heapCount().allocations - allocations;
  }
}

INSTANTIATE_TEST_SUITE_P(Rungs, FollowerAllocation,
                         testing::Values(Model::kCatenary, Model::kCatenaryCorrected, Model::kBending, Model::kAuto),
                         [](const auto& model) { return std::string(modelName(model.param)); });

}  // namespace
}  // namespace cdpr_kinetostatics

// The steps of a continuation: on a problem that fails where it is told to.
#include "cable/bending_path.h"

#include <gtest/gtest.h>

#include <vector>

#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

const SolveOutcome kStarted{{Code::kConverged, ""}, 3};
const SolveOutcome kFailed{{Code::kNotConverged, "too far"}, 1};
const SolveOutcome kSolved{{Code::kConverged, ""}, 2};

struct Path {
  MultipleShooting shooting;
  std::vector<double> shares;

  Path() { shooting.start(steelRope(), 10.0, 800.0, 600.0, 1e-8); }
  SolveOutcome follow(int max_steps, const SolveAtShare& solve) {
    return followPath(
        kStarted, max_steps, "lost on the way",
        [&](double share) {
          shares.push_back(share);
          return solve(share);
        },
        &shooting);
  }
};

TEST(BendingPath, GoesToTheProblemAskedForAndCountsTheWork) {
  Path path;
  const SolveOutcome outcome = path.follow(100, [](double) { return kSolved; });
  EXPECT_TRUE(outcome.ok());
  EXPECT_EQ(path.shares.back(), 1.0);
  EXPECT_EQ(outcome.iterations, 3 + 2 * static_cast<int>(path.shares.size()));
}

// Steps of more than 0.1 fail: shorter ones are tried from the last share that succeeded.
TEST(BendingPath, ShortensStepsThatFail) {
  Path path;
  double last = 0.0;
  const SolveOutcome outcome = path.follow(200, [&](double share) {
    EXPECT_GT(share, last);
    if (share - last > 0.1) return kFailed;
    last = share;
    return kSolved;
  });
  EXPECT_TRUE(outcome.ok());
  EXPECT_EQ(last, 1.0);
}

TEST(BendingPath, AWallEndsItWithTheSentenceAndTheLastEquilibrium) {
  Path path;
  double reached = 0.0;
  const SolveOutcome outcome = path.follow(400, [&](double share) {
    path.shooting.follow({1.0, 0.0, 0.0});  // each try moves the cable, also one that fails
    if (share > 0.4) return kFailed;
    reached = path.shooting.horizontalForce();
    return kSolved;
  });
  EXPECT_EQ(outcome.status.code, Code::kNotConverged);
  EXPECT_EQ(outcome.status.message, "lost on the way");
  EXPECT_LT(path.shares.size(), 100u) << "steps that only shrink come to an end";
  EXPECT_EQ(path.shooting.horizontalForce(), reached);
}

TEST(BendingPath, EndsWhereTimeOrStepsEnd) {
  Path slow;
  const SolveOutcome late{{Code::kTimedOut, "late"}, 1};
  EXPECT_EQ(slow.follow(100, [&](double share) { return share > 0.5 ? late : kSolved; }).status.code, Code::kTimedOut);
  Path few;
  EXPECT_EQ(few.follow(1, [](double) { return kSolved; }).status.code, Code::kNotConverged);
  EXPECT_EQ(few.shares.size(), 1u);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Bars that do not fit, reached by raising their axial stiffness.
#include "robot/stiffening.h"

#include <gtest/gtest.h>

#include "robot_audit.h"
#include "robot_cases.h"
#include "suspended_platform.h"

namespace cdpr_kinetostatics {
namespace {

class Stiffening : public testing::Test {
 protected:
  Stiffening() { lengths_[0] = 4.3; }

  SearchOutcome solve(std::chrono::steady_clock::time_point deadline) {
    state_.pose = robot_.home;
    return stiffen(robot_, Wrench::Zero(), lengths_, std::vector<Model>(8, Model::kBending), {1e-10, deadline},
                   &newton_, &state_);
  }

  const RobotDescription robot_ = suspendedPlatform(shippedRobot(ROBOT_DIR, "paper_point_mass"), 4, 2000.0);
  std::vector<double> lengths_ = std::vector<double>(8, 4.5);
  CoupledNewton newton_{robot_};
  CoupledState state_;
};

TEST_F(Stiffening, EndsInAStableBalanceOfTheRealBars) {
  const SearchOutcome outcome = solve(std::chrono::steady_clock::time_point::max());
  ASSERT_TRUE(outcome.ok()) << outcome.status.message;
  std::vector<PlaneForces> forces;
  for (std::size_t i = 0; i < 8; ++i) {
    const SaggingCable& cable = state_.cables[i];
    EXPECT_EQ(cable.properties().axial_stiffness, robot_.cables[i].properties.axial_stiffness);
    EXPECT_EQ(cable.length(), lengths_[i]);
    forces.push_back({cable.horizontalForce(), cable.verticalForceA(), cable.length()});
  }
  EXPECT_LT(totalWrench(robot_, Wrench::Zero(), state_.pose, forces).norm(), 1e-7 * robot_.weight());
  // The workspace that was handed in holds the real robot's linearisation.
  EXPECT_TRUE(isOnBranch(platformStability(robot_, newton_.stiffness()), state_));
}

TEST_F(Stiffening, StopsAtTheDeadline) {
  EXPECT_FALSE(solve(std::chrono::steady_clock::now() - std::chrono::seconds(1)).ok());
}

}  // namespace
}  // namespace cdpr_kinetostatics

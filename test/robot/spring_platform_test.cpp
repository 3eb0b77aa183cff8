// The platform on springs: wrench and stiffness against differences of the energy, and where a descent ends.
#include "robot/spring_platform.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "robot/platform_statics.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

class SpringsOfCogiro : public testing::Test {
 protected:
  SpringsOfCogiro() {
    for (const CableDescription& cable : robot_.cables) {
      const double length = 0.999 * anchorToAttachment(cable, robot_.home).norm();
      springs_.push_back({cable.properties.axial_stiffness / length, length});
    }
    external_.head<3>() = Eigen::Vector3d(50.0, -30.0, 20.0);
  }

  Pose moved(const Pose& pose, const Wrench& by) const { return displaced(pose, by.head<3>(), by.tail<3>()); }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  std::vector<Spring> springs_;
  Wrench external_ = Wrench::Zero();
};

TEST_F(SpringsOfCogiro, TheWrenchIsTheSlopeOfTheEnergyAndTheStiffnessOfTheWrench) {
  constexpr double kStep = 1e-5;
  const SpringPlatform platform(robot_, &external_);
  Dice dice(51);
  int slack = 0;
  for (int i = 0; i < 10; ++i) {
    const Pose pose = dice.away(robot_.home, 0.05, 0.02);
    const SpringPlatform::Local local = platform.at(pose, springs_);
    for (std::size_t k = 0; k < springs_.size(); ++k) {
      slack += springs_[k].tension(anchorToAttachment(robot_.cables[k], pose).norm()) == 0.0 ? 1 : 0;
    }
    for (int k = 0; k < 6; ++k) {
      const SpringPlatform::Local ahead = platform.at(moved(pose, kStep * Wrench::Unit(k)), springs_);
      const SpringPlatform::Local behind = platform.at(moved(pose, -kStep * Wrench::Unit(k)), springs_);
      EXPECT_NEAR(local.wrench(k), (behind.energy - ahead.energy) / (2.0 * kStep), 1e-6 * local.wrench.norm()) << k;
      EXPECT_LT((local.stiffness.col(k) - (ahead.wrench - behind.wrench) / (2.0 * kStep)).norm(),
                1e-6 * local.stiffness.norm())
          << k;
    }
  }
  EXPECT_GT(slack, 0) << "slack springs are part of the test";
}

TEST_F(SpringsOfCogiro, EveryDescentEndsInAStableBalance) {
  const SpringPlatform platform(robot_, &external_);
  Dice dice(52);
  for (int i = 0; i < 10; ++i) {
    Pose pose = dice.away(robot_.home, 1.5, 0.5);
    const SearchOutcome outcome = platform.descend(springs_, 1e-10, Clock::time_point::max(), &pose);
    ASSERT_TRUE(outcome.ok()) << outcome.status.message;
    EXPECT_GT(outcome.iterations, 0);
    EXPECT_LT(outcome.residuals.force, 1e-6 * robot_.weight());
    const SpringPlatform::Local local = platform.at(pose, springs_);
    EXPECT_NEAR(local.wrench.head<3>().norm(), outcome.residuals.force, 1e-9 * robot_.weight());
    const Eigen::Matrix<double, 6, 6> hessian = -0.5 * (local.stiffness + local.stiffness.transpose());
    EXPECT_GT((Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(hessian).eigenvalues().minCoeff()), 0.0);
  }
}

TEST_F(SpringsOfCogiro, WithoutLoadTheSpringsFitAsWellAsTheyCan) {
  std::vector<Spring> two_sided = springs_;
  for (std::size_t i = 0; i < two_sided.size(); ++i) {
    two_sided[i].length /= 0.999;  // the chords of home: no spring is stretched there
    two_sided[i].two_sided = true;
  }
  Pose pose = Dice(53).away(robot_.home, 0.3, 0.1);
  ASSERT_TRUE(SpringPlatform(robot_, nullptr).descend(two_sided, 1e-12, Clock::time_point::max(), &pose).ok());
  EXPECT_TRUE(samePose(pose, robot_.home, 1e-9));
}

TEST_F(SpringsOfCogiro, StopsAtTheDeadline) {
  Pose pose = robot_.home;
  const SearchOutcome outcome =
      SpringPlatform(robot_, &external_).descend(springs_, 1e-10, Clock::now() - std::chrono::seconds(1), &pose);
  EXPECT_EQ(outcome.status.code, Code::kTimedOut);
  EXPECT_EQ(outcome.iterations, 0);
  EXPECT_GT(outcome.residuals.force, 0.0) << "the seed's";
}

// Upright on two springs with the mass above them: in balance, on a saddle. It turns over.
TEST(Springs, LeaveASaddle) {
  RobotDescription robot;
  robot.mass = 20.0;
  robot.com = {0.0, 0.0, 0.3};
  std::vector<Spring> springs;
  for (const double side : {-1.0, 1.0}) {
    CableDescription cable;
    cable.anchor = {2.0 * side, 0.0, 3.0};
    cable.attachment = {0.5 * side, 0.0, 0.0};
    robot.cables.push_back(cable);
    springs.push_back({1e5, 2.5});
  }
  const Wrench none = Wrench::Zero();
  const SpringPlatform platform(robot, &none);
  Pose pose;
  pose.position = {0.0, 0.0, 1.0};
  const SearchOutcome outcome = platform.descend(springs, 1e-9, Clock::now() + std::chrono::seconds(10), &pose);
  ASSERT_TRUE(outcome.ok()) << outcome.status.message;
  EXPECT_LT((pose.orientation * robot.com).z(), -0.29);
  EXPECT_LT(outcome.residuals.force, 1e-6 * robot.weight());
}

TEST(Springs, PullButDoNotPush) {
  Spring spring{100.0, 2.0, 5.0, false};
  EXPECT_EQ(spring.tension(2.1), 5.0 + 100.0 * (2.1 - 2.0));
  EXPECT_EQ(spring.tension(1.0), 0.0);
  spring.two_sided = true;
  EXPECT_EQ(spring.tension(1.0), -95.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

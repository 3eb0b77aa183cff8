// The steps that a cable without nodes may make.
#include "cable/closed_form_cable.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace cdpr_kinetostatics {
namespace {

ClosedFormCable tautCable() {
  ClosedFormCable cable({1e5, 0.0, 1.0});
  cable.start(10.0, {30.0, 40.0});  // T_A = 50 N
  return cable;
}

TEST(ClosedFormCable, SmallStepsAreTakenWhole) {
  ClosedFormCable cable = tautCable();
  const Eigen::Vector3d change(3.0, -4.0, 0.5);
  EXPECT_EQ(cable.dampingFor(change), 1.0);
  EXPECT_EQ(cable.dampingFor(Eigen::Vector3d::Zero()), 1.0);
  cable.step(change, 0.5);
  EXPECT_EQ(cable.forces().horizontal, 31.5);
  EXPECT_EQ(cable.forces().vertical, 38.0);
  EXPECT_EQ(cable.length(), 10.25);
}

TEST(ClosedFormCable, LargeStepsAreShortened) {
  const ClosedFormCable cable = tautCable();
  // A tenth of the length at most, forces at most doubled, and a fifth of H left.
  EXPECT_NEAR(cable.dampingFor({0.0, 0.0, -5.0}), 0.2, 1e-15);
  EXPECT_NEAR(cable.dampingFor({60.0, 80.0, 0.0}), 0.5, 1e-15);
  EXPECT_NEAR(cable.dampingFor({-48.0, 0.0, 0.0}), 0.5, 1e-15);
}

TEST(ClosedFormCable, IsOnItsBranchUnlessItPushes) {
  ClosedFormCable cable = tautCable();
  EXPECT_TRUE(cable.onBranch());
  cable.start(10.0, {-1.0, 5.0});
  EXPECT_FALSE(cable.onBranch());
}

}  // namespace
}  // namespace cdpr_kinetostatics

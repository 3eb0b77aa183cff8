// The platform's weight and load, and how they change with the pose.
#include "robot/platform_statics.h"

#include <gtest/gtest.h>

#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

class PlatformStatics : public testing::Test {
 protected:
  PlatformStatics() {
    robot_.com = {0.1, -0.2, 0.3};
    external_ << 5.0, -3.0, 2.0, 0.4, -0.6, 0.8;
  }

  RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  Wrench external_;
  Dice dice_{21};
};

TEST_F(PlatformStatics, TheLoadIsWeightAndWrench) {
  for (int i = 0; i < 10; ++i) {
    const Pose pose = dice_.away(robot_.home, 1.0, 0.5);
    const Wrench expected = totalWrench(robot_, external_, pose, {});
    EXPECT_LT((loadWrench(robot_, pose, external_) - expected).norm(), 1e-12 * expected.norm());
  }
}

TEST_F(PlatformStatics, TheWeightsStiffnessIsTheDerivativeOfTheLoad) {
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 10; ++i) {
    const Pose pose = dice_.away(robot_.home, 1.0, 0.5);
    const Eigen::Matrix<double, 6, 6> stiffness = weightStiffness(robot_, pose);
    for (int k = 0; k < 6; ++k) {
      const Wrench move = kStep * Wrench::Unit(k);
      const Wrench slope = (loadWrench(robot_, displaced(pose, move.head<3>(), move.tail<3>()), external_) -
                            loadWrench(robot_, displaced(pose, -move.head<3>(), -move.tail<3>()), external_)) /
                           (2.0 * kStep);
      EXPECT_LT((stiffness.col(k) - slope).norm(), 1e-8 * robot_.weight()) << k;
    }
  }
}

TEST_F(PlatformStatics, CablesEndAtTheirAttachments) {
  const Pose pose = dice_.away(robot_.home, 1.0, 0.5);
  for (const CableDescription& cable : robot_.cables) {
    const Eigen::Vector3d to_b = attachmentInWorld(pose, cable.attachment) - cable.anchor;
    EXPECT_LT((anchorToAttachment(cable, pose) - to_b).norm(), 1e-14);
    EXPECT_NEAR(cablePlane(cable, pose).x, to_b.head<2>().norm(), 1e-14);
    EXPECT_NEAR(cablePlane(cable, pose).y, to_b.z(), 1e-14);
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

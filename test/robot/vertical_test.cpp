// Cables that hang exactly straight down: the limit of cables a little beside that, by every model.
#include <gtest/gtest.h>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kDrop = 3.0;  // of the ropes [m]

CableDescription rope(const Eigen::Vector3d& corner) {
  CableDescription cable;
  cable.name = "rope" + std::to_string(corner.x()) + std::to_string(corner.y());
  cable.properties = {1e5, 0.5, 0.6};
  cable.anchor = corner + kDrop * Eigen::Vector3d::UnitZ();
  cable.attachment = corner;
  cable.tension_min = 1.0;
  cable.tension_max = 1e4;
  return cable;
}

// Four ropes; the anchors are further apart than the attachments by that share.
RobotDescription hoist(double spread = 0.0) {
  RobotDescription robot;
  robot.name = "hoist";
  robot.mass = 20.0;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) robot.cables.push_back(rope({x, y, 0.0}));
  }
  for (CableDescription& cable : robot.cables) cable.anchor.head<2>() *= 1.0 + spread;
  return robot;
}

RobotDescription pendulum() {
  RobotDescription robot;
  robot.name = "pendulum";
  robot.type = PlatformType::kPointMass;
  robot.mass = 20.0;
  robot.cables.push_back(rope(Eigen::Vector3d::Zero()));
  return robot;
}

class Vertical : public testing::TestWithParam<Model> {};

TEST_P(Vertical, RopesAreLikeThoseALittleBesideThat) {
  const RobotDescription robot = hoist();
  const InverseRequest request = requestFor(robot, robot.home);
  const RobotSolution vertical = solveInverse(robot, request, patient(GetParam()));
  const RobotSolution beside = solveInverse(hoist(1e-7), request, patient(GetParam()));
  ASSERT_TRUE(vertical.report.status.ok()) << vertical.report.status.message;
  ASSERT_TRUE(beside.report.status.ok()) << beside.report.status.message;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    EXPECT_NEAR(vertical.cables[i].cable.length, beside.cables[i].cable.length, 1e-7 * kDrop);
    EXPECT_EQ(vertical.cables[i].cable.model, beside.cables[i].cable.model);
  }
  EXPECT_NEAR(vertical.report.estimated_error, beside.report.estimated_error,
              1e-9 + 1e-3 * beside.report.estimated_error);
}

// What a model neglects is how far the platform moves when its lengths are applied to the finest one.
TEST_P(Vertical, ErrorIsEstimated) {
  const RobotDescription robot = hoist();
  const RobotSolution vertical = solveInverse(robot, requestFor(robot, robot.home), patient(GetParam()));
  ASSERT_TRUE(vertical.report.status.ok()) << vertical.report.status.message;
  ForwardRequest request;
  request.lengths = lengthsOf(vertical);
  const RobotSolution applied = solveForward(robot, request, patient(Model::kBending, 1e-11));
  ASSERT_TRUE(applied.report.status.ok()) << applied.report.status.message;
  const double error = applied.pose.position.norm();
  EXPECT_NEAR(vertical.report.estimated_error, error, 1e-9 + 0.05 * error);
}

// Only one that stretches: what cannot give has no stiffness to solve with.
TEST_P(Vertical, MassOnOneRopeHangsBelowItsAnchor) {
  const RobotDescription robot = pendulum();
  ForwardRequest request;
  request.lengths = {kDrop};
  for (const double beside : {0.0, 0.3}) {
    request.seed = Pose();
    request.seed->position.x() = beside;
    const RobotSolution found = solveForward(robot, request, patient(GetParam()));
    if (isInextensible(GetParam()) && !found.report.status.ok()) {
      EXPECT_EQ(found.report.status.code, Code::kNotConverged);
      continue;
    }
    ASSERT_TRUE(found.report.status.ok()) << found.report.status.message;
    EXPECT_LT(found.pose.position.head<2>().norm(), 1e-6);
    const CableProperties& cable = robot.cables[0].properties;
    const double strain = (robot.weight() + 0.5 * cable.weight * kDrop) / cable.axial_stiffness;
    EXPECT_NEAR(found.pose.position.z(), isInextensible(GetParam()) ? 0.0 : -strain * kDrop, 1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Vertical,
                         testing::Values(Model::kAuto, Model::kStraight, Model::kStraightElastic,
                                         Model::kCatenaryInextensible, Model::kCatenary, Model::kCatenaryCorrected,
                                         Model::kBendingInextensible, Model::kBending),
                         [](const auto& model) { return std::string(modelName(model.param)); });

}  // namespace
}  // namespace cdpr_kinetostatics

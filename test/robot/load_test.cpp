// External wrench, centre of mass and seeds: symmetries and equivalences that every solve must respect.
#include <gtest/gtest.h>

#include <string>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot/platform_statics.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

class Loads : public testing::TestWithParam<Model> {
 protected:
  RobotSolution forward(const RobotDescription& robot, const std::vector<double>& lengths, const Wrench& external,
                        const Pose& seed) const {
    ForwardRequest request;
    request.lengths = lengths;
    request.external_wrench = external;
    request.seed = seed;
    return solveForward(robot, request, patient(GetParam(), 1e-10));
  }
  std::vector<double> homeLengths(const RobotDescription& robot) const {
    const RobotSolution at = solveInverse(robot, requestFor(robot, robot.home), patient(GetParam(), 1e-10));
    EXPECT_TRUE(at.report.status.ok()) << at.report.status.message;
    return lengthsOf(at);
  }

  const RobotDescription cogiro_ = shippedRobot(ROBOT_DIR, "cogiro");
};

TEST_P(Loads, RoundTripUnderAWrenchWithTorque) {
  Dice dice(101);
  int done = 0;
  for (int tried = 0; done < 10 && tried < 100; ++tried) {
    InverseRequest request;
    request.pose = randomPose(workspaceOf("cogiro"), &dice);
    request.external_wrench << 0.3 * cogiro_.weight() * dice.direction(), 0.1 * cogiro_.weight() * dice.direction();
    const RobotSolution inverse = solveInverse(cogiro_, request, patient(GetParam(), 1e-10));
    if (inverse.report.status.code == Code::kInfeasible) continue;
    ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    ++done;
    const RobotSolution solution =
        forward(cogiro_, lengthsOf(inverse), request.external_wrench, dice.away(request.pose, 0.3, 0.1));
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    EXPECT_TRUE(samePose(solution.pose, request.pose, 1e-6));
    const RobotAudit a = audit(cogiro_, request.external_wrench, solution);
    EXPECT_LT(a.force, 1e-9);
    EXPECT_LT(a.moment, 1e-9);
  }
  EXPECT_EQ(done, 10);
}

// Weight off the origin is weight at the origin and a torque, at the pose where that torque is taken.
TEST_P(Loads, CentreOfMassActsAsItsTorque) {
  const std::vector<double> lengths = homeLengths(cogiro_);
  const RobotSolution with_com = forward(cogiro_, lengths, Wrench::Zero(), cogiro_.home);
  ASSERT_TRUE(with_com.report.status.ok());
  RobotDescription centred = cogiro_;
  centred.com.setZero();
  Wrench torque = Wrench::Zero();
  const Eigen::Vector3d arm = attachmentInWorld(with_com.pose, cogiro_.com) - with_com.pose.position;
  torque.tail<3>() = arm.cross(Eigen::Vector3d(0.0, 0.0, -cogiro_.weight()));
  const RobotSolution with_torque = forward(centred, lengths, torque, cogiro_.home);
  ASSERT_TRUE(with_torque.report.status.ok());
  EXPECT_TRUE(samePose(with_com.pose, with_torque.pose, 1e-8));
}

TEST_P(Loads, AVerticalForceActsAsMass) {
  const std::vector<double> lengths = homeLengths(cogiro_);
  RobotDescription heavy = cogiro_;
  heavy.com.setZero();
  RobotDescription light = heavy;
  light.mass *= 0.7;
  Wrench rest = Wrench::Zero();
  rest.z() = -(heavy.weight() - light.weight());
  const RobotSolution a = forward(heavy, lengths, Wrench::Zero(), cogiro_.home);
  const RobotSolution b = forward(light, lengths, rest, cogiro_.home);
  ASSERT_TRUE(a.report.status.ok() && b.report.status.ok());
  EXPECT_TRUE(samePose(a.pose, b.pose, 1e-8));
}

// The world turned about the vertical and shifted: the answer turns and shifts with it.
TEST_P(Loads, AnswersDoNotDependOnWhereTheWorldIs) {
  const std::vector<double> lengths = homeLengths(cogiro_);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()));
  const Eigen::Vector3d shift(30.0, -20.0, 7.0);
  RobotDescription moved = cogiro_;
  for (CableDescription& cable : moved.cables) cable.anchor = turn * cable.anchor + shift;
  moved.home.position = turn * cogiro_.home.position + shift;
  moved.home.orientation = turn * cogiro_.home.orientation;
  Wrench external, turned;
  external << 40.0, -30.0, 20.0, 15.0, 10.0, -5.0;
  turned << turn * external.head<3>(), turn * external.tail<3>();
  const RobotSolution a = forward(cogiro_, lengths, external, cogiro_.home);
  const RobotSolution b = forward(moved, lengths, turned, moved.home);
  ASSERT_TRUE(a.report.status.ok() && b.report.status.ok());
  EXPECT_LT((b.pose.position - (turn * a.pose.position + shift)).norm(), 1e-8);
  EXPECT_LT(b.pose.orientation.angularDistance(turn * a.pose.orientation), 1e-8);
}

TEST_P(Loads, TheSeedDoesNotChangeTheAnswerOfARedundantRobot) {
  const std::vector<double> lengths = homeLengths(cogiro_);
  Dice dice(102);
  for (int i = 0; i < 10; ++i) {
    const RobotSolution solution = forward(cogiro_, lengths, Wrench::Zero(), dice.away(cogiro_.home, 0.5, 0.2));
    ASSERT_TRUE(solution.report.status.ok()) << "seed " << i << ": " << solution.report.status.message;
    EXPECT_TRUE(samePose(solution.pose, cogiro_.home, 1e-7)) << "seed " << i;
  }
}

TEST_P(Loads, WithoutASeedHomeIsTheSeed) {
  ForwardRequest request;
  request.lengths = homeLengths(cogiro_);
  const RobotSolution without = solveForward(cogiro_, request, patient(GetParam()));
  request.seed = cogiro_.home;
  const RobotSolution with = solveForward(cogiro_, request, patient(GetParam()));
  ASSERT_TRUE(without.report.status.ok());
  EXPECT_EQ(without.pose.position, with.pose.position);
  EXPECT_EQ(without.pose.orientation.coeffs(), with.pose.orientation.coeffs());
}

INSTANTIATE_TEST_SUITE_P(Models, Loads,
                         testing::Values(Model::kCatenaryInextensible, Model::kCatenary, Model::kBendingInextensible,
                                         Model::kBending),
                         [](const testing::TestParamInfo<Model>& each) { return std::string(modelName(each.param)); });

}  // namespace
}  // namespace cdpr_kinetostatics

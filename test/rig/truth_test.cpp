// The rig's truth: lengths that forward kinetostatics takes back to the pose, a lap that is remembered for its load
// alone, and loads that are drawn as asked for.

#include "rig/truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "rig/load.h"

namespace cdpr_kinetostatics {
namespace {

RigParameters rig(const std::string& robot) {
  RigParameters parameters;
  parameters.robot = loadRobotFile(ROBOT_DIR "/" + robot + ".yaml").robot;
  return parameters;
}

TEST(RigTruth, GoesBackToThePoseUnderItsLoad) {
  for (const char* name : {"cogiro", "scampi", "paper_point_mass"}) {
    SCOPED_TRACE(name);
    const RigParameters parameters = rig(name);
    Wrench load = Wrench::Zero();
    load(2) = -0.05 * parameters.robot.weight();
    RigTruth truth;
    const Status status = solveRig(parameters, parameters.robot.home, load, Model::kBending, &truth);
    ASSERT_TRUE(status.ok()) << status.message;
    ForwardRequest request;
    request.lengths = truth.lengths;
    request.external_wrench = load;
    RobotSolverOptions options;
    options.timeout = std::chrono::duration<double>(10.0);
    const RobotSolution back = solveForward(parameters.robot, request, options);
    ASSERT_TRUE(back.report.status.ok()) << back.report.status.message;
    EXPECT_LT((back.pose.position - truth.pose.position).norm(), 1e-7 * parameters.robot.span());
    for (std::size_t i = 0; i < truth.tensions.size(); ++i) {
      EXPECT_NEAR(back.cables[i].cable.tension_a, truth.tensions[i], 1e-4 * (1.0 + std::abs(truth.tensions[i])));
    }
  }
}

// The two cables cannot hold the point mass against a force across their plane: it swings out, by force over weight
// times the depth below the line of the anchors.
TEST(RigTruth, GivesWayToALoadThatNobodyKnows) {
  const RigParameters parameters = rig("paper_point_mass");
  RigTruth truth;
  ASSERT_TRUE(solveRig(parameters, parameters.robot.home, Wrench::Zero(), Model::kBending, &truth).ok());
  const RigTruth before = truth;
  const Wrench load = 0.01 * parameters.robot.weight() * Wrench::Unit(1);
  const Status status = disturbRig(parameters, load, &truth);
  ASSERT_TRUE(status.ok()) << status.message;
  EXPECT_EQ(truth.lengths, before.lengths);
  const Eigen::Vector3d along = parameters.robot.cables[1].anchor - parameters.robot.cables[0].anchor;
  const Eigen::Vector3d below = before.pose.position - parameters.robot.cables[0].anchor;
  const double depth = along.z() / along.x() * below.x() - below.z();
  EXPECT_GT(truth.pose.position.y(), 0.0);
  EXPECT_NEAR(truth.pose.position.y(), 0.01 * depth, 0.05 * 0.01 * depth) << "the cables' weight is 2 % of the load";
}

TEST(RigTruth, SaysWhyAPoseCannotBeHeld) {
  const RigParameters parameters = rig("cogiro");
  Pose pose = parameters.robot.home;
  pose.position.x() += 100.0;
  RigTruth truth;
  const Status status = solveRig(parameters, pose, Wrench::Zero(), Model::kCatenary, &truth);
  EXPECT_FALSE(status.ok());
  EXPECT_FALSE(status.message.empty());
}

TEST(RigLap, IsRememberedForItsLoad) {
  const Wrench none = Wrench::Zero(), payload = Wrench::Unit(2);
  RigTruth truth;
  truth.lengths = {1.0, 2.0};
  RigLap lap(10);
  EXPECT_EQ(lap.find(3, none), nullptr);
  lap.remember(3, none, truth);
  ASSERT_NE(lap.find(3, none), nullptr);
  EXPECT_EQ(lap.find(13, none)->lengths, truth.lengths);
  EXPECT_EQ(lap.find(4, none), nullptr);
  EXPECT_EQ(lap.find(3, payload), nullptr);
  lap.remember(4, payload, truth);
  EXPECT_EQ(lap.find(3, none), nullptr);
  EXPECT_EQ(lap.find(3, payload), nullptr);
  EXPECT_NE(lap.find(14, payload), nullptr);
  RigLap nothing(0);
  nothing.remember(3, none, truth);
  EXPECT_EQ(nothing.find(3, none), nullptr);
}

TEST(RigLoad, IsTheLastGiven) {
  RigParameters parameters = rig("cogiro");
  EXPECT_EQ(rigLoad(parameters, 3.0), Wrench::Zero());
  parameters.loads = {{1.0, Wrench::Unit(0)}, {2.0, Wrench::Unit(1)}};
  EXPECT_EQ(rigLoad(parameters, 0.5), Wrench::Zero());
  EXPECT_EQ(rigLoad(parameters, 1.0), Wrench::Unit(0));
  EXPECT_EQ(rigLoad(parameters, 2.5), Wrench::Unit(1));
}

// Of n draws the mean is within 5 / sqrt(n) and the variance within 5 sqrt(2/n) of what they should be.
TEST(RigLoad, IsDrawnEverySecondWithTheDeviationAskedFor) {
  RigParameters parameters = rig("cogiro");
  parameters.load_noise = 0.01;
  const double force = 0.01 * parameters.robot.weight();
  EXPECT_EQ(unknownRigLoad(parameters, 7.1), unknownRigLoad(parameters, 7.9));
  EXPECT_NE(unknownRigLoad(parameters, 7.9), unknownRigLoad(parameters, 8.1));
  constexpr int kDraws = 4000;
  Wrench sum = Wrench::Zero(), squares = Wrench::Zero();
  for (int k = 0; k < kDraws; ++k) {
    Wrench draw = unknownRigLoad(parameters, k + 0.5) / force;
    draw.tail<3>() /= parameters.robot.platformRadius();
    sum += draw;
    squares += draw.cwiseAbs2();
  }
  const Wrench mean = sum / kDraws;
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 5.0 / std::sqrt(kDraws));
  EXPECT_LT((squares / kDraws - Wrench::Ones()).cwiseAbs().maxCoeff(), 5.0 * std::sqrt(2.0 / kDraws));

  RigParameters other_seed = parameters;
  other_seed.sensors.seed = 2;
  EXPECT_NE(unknownRigLoad(other_seed, 7.1), unknownRigLoad(parameters, 7.1));
  RigParameters point = rig("paper_point_mass");
  point.load_noise = 0.01;
  EXPECT_NE(unknownRigLoad(point, 0.0).head<3>().norm(), 0.0);
  EXPECT_EQ(unknownRigLoad(point, 0.0).tail<3>().norm(), 0.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

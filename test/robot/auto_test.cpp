// AUTO: as accurate as asked for, as coarse as that allows, without jumps and flicker.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

RobotSolverOptions automatic(double accuracy, double tolerance = 1e-8) {
  RobotSolverOptions options = patient(Model::kAuto, tolerance);
  options.accuracy = accuracy;
  return options;
}

double apart(const RobotSolution& a, const RobotSolution& b) { return (a.pose.position - b.pose.position).norm(); }

std::vector<Model> rungsOf(const RobotSolution& solution) {
  std::vector<Model> rungs;
  for (const CableResult& cable : solution.cables) rungs.push_back(cable.cable.model);
  return rungs;
}

class Auto : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    workspace_ = workspaceOf(GetParam());
    robot_ = shippedRobot(ROBOT_DIR, GetParam());
  }

  // A pose of the workspace that the robot can hold, with the finest model's lengths.
  RobotSolution nextScene() {
    for (int k = 0; k < 100; ++k) {
      RobotSolution scene =
          solveInverse(robot_, requestFor(robot_, randomPose(workspace_, &dice_)), patient(Model::kBending, 1e-10));
      if (scene.report.status.ok()) return scene;
    }
    ADD_FAILURE() << "no pose of " << GetParam() << " can be held";
    return {};
  }

  Workspace workspace_;
  RobotDescription robot_;
  Dice dice_{99};
};

TEST_P(Auto, IsAsAccurateAsAskedFor) {
  for (const double accuracy : {1e-2, 1e-4, 1e-6}) {
    const RobotSolution scene = nextScene();
    const RobotSolution truth = forward(robot_, lengthsOf(scene), scene.pose, patient(Model::kBending, 1e-11));
    const RobotSolution found = forward(robot_, lengthsOf(scene), scene.pose, automatic(accuracy));
    ASSERT_TRUE(truth.report.status.ok() && found.report.status.ok()) << found.report.status.message;
    EXPECT_LE(apart(found, truth), accuracy) << accuracy;
    EXPECT_LE(found.report.estimated_error, accuracy) << accuracy;
    EXPECT_FALSE(found.report.status.message.empty());

    const InverseRequest request = requestFor(robot_, scene.pose);
    const RobotSolution inverse = solveInverse(robot_, request, automatic(accuracy));
    ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    const RobotSolution applied = forward(robot_, lengthsOf(inverse), inverse.pose, patient(Model::kBending, 1e-11));
    EXPECT_LE(apart(inverse, applied), accuracy) << accuracy;
  }
}

TEST_P(Auto, UsesNoCoarserRungForMoreAccuracy) {
  const RobotSolution scene = nextScene();
  int finest = 0;
  for (const double accuracy : {1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const RobotSolution found = forward(robot_, lengthsOf(scene), scene.pose, automatic(accuracy));
    ASSERT_TRUE(found.report.status.ok()) << found.report.status.message;
    EXPECT_GE(static_cast<int>(found.report.model), finest) << accuracy;
    finest = static_cast<int>(found.report.model);
  }
}

TEST_P(Auto, EveryRungReportsWhatItNeglects) {
  const RobotSolution scene = nextScene();
  const RobotSolution truth = forward(robot_, lengthsOf(scene), scene.pose, patient(Model::kBending, 1e-12));
  for (const Model model : {Model::kCatenary, Model::kCatenaryCorrected}) {
    const RobotSolution coarse = forward(robot_, lengthsOf(scene), scene.pose, patient(model, 1e-12));
    if (coarse.report.status.code == Code::kNotConverged) continue;  // no first-order effect describes it
    ASSERT_TRUE(coarse.report.status.ok()) << coarse.report.status.message;
    if (!coarse.report.error_known || apart(coarse, truth) < 1e-10 * robot_.span()) continue;
    EXPECT_GT(coarse.report.estimated_error, 0.2 * apart(coarse, truth)) << modelName(model);
    EXPECT_LT(coarse.report.estimated_error, 5.0 * apart(coarse, truth)) << modelName(model);
  }
  EXPECT_EQ(truth.report.estimated_error, 0.0);
}

// The platform moves in small steps: where AUTO changes a rung, its pose jumps by less than the accuracy.
TEST_P(Auto, DoesNotJumpWhereItChangesItsRungs) {
  const RobotSolution a = nextScene();
  const RobotSolution b = nextScene();
  const double accuracy = 1e-4;
  RobotSolution last_truth, last;
  int changes = 0;
  for (int k = 0; k <= 60; ++k) {
    std::vector<double> lengths = lengthsOf(a);
    for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] += k / 600.0 * (lengthsOf(b)[i] - lengths[i]);
    const RobotSolution truth = forward(robot_, lengths, a.pose, patient(Model::kBending, 1e-10));
    const RobotSolution found = forward(robot_, lengths, a.pose, automatic(accuracy));
    if (!truth.report.status.ok()) break;  // lengths between two poses need not be those of a third one
    ASSERT_TRUE(found.report.status.ok()) << found.report.status.message;
    EXPECT_LE(apart(found, truth), accuracy) << k;
    if (k > 0) {
      const Eigen::Vector3d step = found.pose.position - last.pose.position;
      const Eigen::Vector3d true_step = truth.pose.position - last_truth.pose.position;
      EXPECT_LT((step - true_step).norm(), accuracy) << k;
      changes += rungsOf(found) != rungsOf(last);
    }
    last = found;
    last_truth = truth;
  }
  RecordProperty("rung_changes", changes);
}

// No model finer than the line knows the shape of what has neither weight nor stiffness.
TEST(AutoAlone, SlackLinesWithoutWeightAreExact) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "ipanema3");
  for (CableDescription& cable : robot.cables) {
    cable.properties.weight = 0.0;
    cable.properties.bending_stiffness = 0.0;
  }
  RobotSolution home = solveInverse(robot, requestFor(robot, robot.home), patient(Model::kStraightElastic));
  ASSERT_TRUE(home.report.status.ok()) << home.report.status.message;
  std::vector<double> lengths = lengthsOf(home);
  lengths.front() *= 1.1;
  const RobotSolution found = forward(robot, lengths, robot.home, automatic(1e-6));
  ASSERT_TRUE(found.report.status.ok()) << found.report.status.message;
  EXPECT_EQ(found.cables.front().condition, Condition::kSlack);
  EXPECT_LT(found.report.estimated_error, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Shipped, Auto,
                         testing::Values("cogiro", "caroca", "ipanema3", "desktop_music_wire", "fast", "scampi",
                                         "paper_point_mass"),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace cdpr_kinetostatics

// A cable that hangs exactly vertical, where H, its density and the direction in the plane say nothing of each other.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "simulated_measurements.h"

namespace cdpr_kinetostatics {
namespace {

RobotDescription robotOn(PlatformType type, const std::vector<Eigen::Vector3d>& anchors,
                         const std::vector<Eigen::Vector3d>& attachments) {
  RobotDescription robot;
  robot.name = "vertical";
  robot.type = type;
  robot.mass = 20.0;
  if (type == PlatformType::kRigidBody) robot.com = Eigen::Vector3d(0.0, 0.0, -0.1);
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    CableDescription cable;
    cable.name = "cable" + std::to_string(i);
    cable.anchor = anchors[i];
    cable.attachment = attachments[i];
    cable.properties.axial_stiffness = 1e5;
    cable.properties.bending_stiffness = 0.1;
    cable.properties.weight = 0.5;
    cable.tension_min = 0.0;
    cable.tension_max = 2000.0;
    robot.cables.push_back(cable);
  }
  robot.home.position = Eigen::Vector3d(0.0, 0.0, 1.0);
  return robot;
}

// One rope of three hangs down from above.
RobotDescription pointMass() {
  return robotOn(PlatformType::kPointMass, {{-3.0, 0.0, 4.0}, {3.0, 0.0, 4.0}, {0.0, 0.0, 4.0}},
                 std::vector<Eigen::Vector3d>(3, Eigen::Vector3d::Zero()));
}

// A swing on four parallel ropes.
RobotDescription swing() {
  std::vector<Eigen::Vector3d> anchors, attachments;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      anchors.emplace_back(x, y, 4.0);
      attachments.emplace_back(x, y, 0.0);
    }
  }
  return robotOn(PlatformType::kRigidBody, anchors, attachments);
}

// How far beside the vertical the truth is, and how far from the truth the estimator starts [m].
struct Case {
  double beside;
  double away;
};

class VerticalCables : public testing::TestWithParam<std::tuple<Model, Case>> {
 protected:
  static void expectFound(const RobotDescription& robot) {
    const auto [model, place] = GetParam();
    SimulatedRobot simulated;
    simulated.robot = robot;
    simulated.estimator.model = model == Model::kAuto ? Model::kBending : model;
    simulated.estimator.load_stddev = EstimatorOptions::defaultLoadStddev(robot);
    simulated.estimator.timeout = std::chrono::duration<double>(10.0);
    Pose pose = robot.home;
    pose.position.x() += place.beside;
    ASSERT_TRUE(simulated.moveTo(pose));
    const CableMeasurements measured = simulated.measure(simulated.truth, 0.0);
    EstimatorOptions options = simulated.estimator;
    options.model = model;
    PoseEstimator estimator(simulated.robot, options);
    Pose seed = simulated.truth.pose;
    seed.position.x() += place.away;
    estimator.setPose(seed);
    for (int k = 0; k < 3; ++k) {
      const Estimate estimate = estimator.update(measured);
      ASSERT_TRUE(estimate.solution.report.status.ok()) << k << ": " << estimate.solution.report.status.message;
      const Wrench error = poseError(estimate.solution.pose, simulated.truth.pose);
      EXPECT_LT(error.head(robot.freedoms()).norm(), model == Model::kAuto ? options.accuracy : 1e-6) << k;
      for (std::size_t i = 0; i < robot.cables.size(); ++i) {
        EXPECT_FALSE(estimate.length_outlier[i] || estimate.tension_outlier[i]) << k;
        EXPECT_NEAR(estimate.solution.cables[i].cable.tension_a, *measured.tensions[i],
                    model == Model::kAuto ? 0.1 * options.tension_stddev : 1e-2)
            << k;
      }
      EXPECT_TRUE(estimate.covariance.allFinite() && estimate.load_covariance.allFinite()) << k;
    }
  }
};

TEST_P(VerticalCables, OfAPointMass) { expectFound(pointMass()); }

TEST_P(VerticalCables, OfASwing) { expectFound(swing()); }

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double beside : {0.0, 1e-12, 1e-9}) {
    for (const double away : {0.0, 0.05, 0.5}) all.push_back({beside, away});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(At, VerticalCables,
                         testing::Combine(testing::Values(Model::kCatenary, Model::kBending, Model::kAuto),
                                          testing::ValuesIn(cases())),
                         [](const auto& at) {
                           return std::string(modelName(std::get<0>(at.param))) + "_" + std::to_string(at.index);
                         });

}  // namespace
}  // namespace cdpr_kinetostatics

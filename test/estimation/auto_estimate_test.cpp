// AUTO in the estimator: what the rungs neglect stays within the accuracy, and the rungs do not flicker.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "simulated_measurements.h"

namespace cdpr_kinetostatics {
namespace {

std::vector<Model> rungsOf(const Estimate& estimate) {
  std::vector<Model> rungs;
  for (const CableResult& cable : estimate.solution.cables) rungs.push_back(cable.cable.model);
  return rungs;
}

class AutoEstimate : public testing::TestWithParam<std::string> {
 protected:
  SimulatedRobot simulated_ = simulatedRobot(ROBOT_DIR, GetParam(), Model::kBending);

  Estimate estimate(Model model, double accuracy) {
    EstimatorOptions options = simulated_.estimator;
    options.model = model;
    options.accuracy = accuracy;
    PoseEstimator estimator(simulated_.robot, options);
    return estimator.update(simulated_.measure(simulated_.truth, 0.0));
  }

  double error(const Estimate& estimate) const {
    return (estimate.solution.pose.position - simulated_.truth.pose.position).norm();
  }
};

TEST_P(AutoEstimate, IsAsAccurateAsAskedFor) {
  for (const double accuracy : {1e-2, 1e-4, 1e-6}) {
    const Estimate found = estimate(Model::kAuto, accuracy);
    ASSERT_TRUE(found.solution.report.status.ok()) << found.solution.report.status.message;
    EXPECT_LE(error(found), accuracy);
    EXPECT_LE(found.solution.report.estimated_error, accuracy);
  }
}

TEST_P(AutoEstimate, TheCatenarySaysWhatItNeglects) {
  const Estimate found = estimate(Model::kCatenary, 1.0);
  ASSERT_TRUE(found.solution.report.status.ok()) << found.solution.report.status.message;
  if (!found.solution.report.error_known || error(found) < 1e-10 * simulated_.robot.span()) return;
  EXPECT_GT(found.solution.report.estimated_error, 0.2 * error(found));
  EXPECT_LT(found.solution.report.estimated_error, 5.0 * error(found));
}

TEST_P(AutoEstimate, ItsRungsDoNotFlickerUnderNoise) {
  for (const double accuracy : {1e-3, 1e-5, 1e-7}) {
    EstimatorOptions options = simulated_.estimator;
    options.model = Model::kAuto;
    options.accuracy = accuracy;
    PoseEstimator estimator(simulated_.robot, options);
    std::vector<Model> last;
    int changes = 0;
    for (int k = 0; k < 60; ++k) {
      const Estimate found = estimator.update(simulated_.measure(simulated_.truth, 0.1));
      ASSERT_TRUE(found.solution.report.status.ok()) << found.solution.report.status.message;
      if (k > 2) changes += rungsOf(found) != last;
      last = rungsOf(found);
    }
    EXPECT_LE(changes, 2) << accuracy;
  }
}

TEST_P(AutoEstimate, TheSameMessagesGiveTheSameEstimates) {
  EstimatorOptions options = simulated_.estimator;
  options.model = Model::kAuto;
  std::vector<CableMeasurements> messages;
  for (int k = 0; k < 5; ++k) messages.push_back(simulated_.measure(simulated_.truth, 1.0));
  PoseEstimator estimator(simulated_.robot, options);
  std::vector<Eigen::Vector3d> first;
  for (const CableMeasurements& message : messages) first.push_back(estimator.update(message).solution.pose.position);
  estimator.reset();
  for (std::size_t k = 0; k < messages.size(); ++k) {
    EXPECT_EQ(estimator.update(messages[k]).solution.pose.position, first[k]) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, AutoEstimate,
                         testing::Values("cogiro", "caroca", "ipanema3", "desktop_music_wire", "scampi"),
                         [](const auto& robot) { return robot.param; });

// What a coarse rung leaves out must never pass for a fault: not in the first estimate, nor ever after.
TEST(AutoEstimateOnExactData, TakesNoModelErrorForAFault) {
  for (const double stiffer : {1.0, 100.0}) {
    SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "caroca", Model::kBending);
    for (CableDescription& cable : simulated.robot.cables) cable.properties.bending_stiffness *= stiffer;
    for (const Eigen::Vector3d& step : {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.2, -0.3, 0.2),
                                        Eigen::Vector3d(-0.3, 0.2, -0.1), Eigen::Vector3d(0.1, 0.3, 0.3)}) {
      Pose pose = simulated.robot.home;
      pose.position += step;
      ASSERT_TRUE(simulated.moveTo(pose));
      const CableMeasurements exact = simulated.measure(simulated.truth, 0.0);
      for (const double length_stddev : {1e-3, 1e-4, 1e-5}) {
        for (const double tension_stddev : {5.0, 0.1}) {
          for (const double accuracy : {1e-4, 0.1 * length_stddev}) {
            EstimatorOptions options = simulated.estimator;
            options.model = Model::kAuto;
            options.length_stddev = length_stddev;
            options.tension_stddev = tension_stddev;
            options.accuracy = accuracy;
            PoseEstimator estimator(simulated.robot, options);
            for (int k = 0; k < 3; ++k) {
              SCOPED_TRACE(testing::Message()
                           << "EI x " << stiffer << ", pose " << step.transpose() << ", " << length_stddev << " m, "
                           << tension_stddev << " N, accuracy " << accuracy << ", message " << k);
              const Estimate found = estimator.update(exact);
              ASSERT_TRUE(found.solution.report.status.ok()) << found.solution.report.status.message;
              const std::vector<bool> none(simulated.robot.cables.size(), false);
              EXPECT_EQ(found.length_outlier, none);
              EXPECT_EQ(found.tension_outlier, none);
              EXPECT_FALSE(found.load_outlier.any());
              EXPECT_LE((found.solution.pose.position - simulated.truth.pose.position).norm(), accuracy);
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

#include "estimation/cold_start.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measured_truth.h"
#include "simulated_measurements.h"

namespace cdpr_kinetostatics {
namespace {

// Taut cables begin with the tension that was measured, along the chord; the pose is near the truth.
TEST(ColdStart, HasTheMeasuredTensionsNearTheTruth) {
  for (const char* name : {"cogiro", "caroca", "ipanema3"}) {
    SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, name);
    const CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
    const MeasuredRobot measured = measuredBy(simulated, measurements);
    int iterations = 0;
    const RobotForces start = coldStart(measured, simulated.robot.home, &iterations);
    EXPECT_GT(iterations, 0) << name;
    EXPECT_LT((start.pose.position - simulated.truth.pose.position).norm(), 0.05 * simulated.robot.span()) << name;
    for (std::size_t i = 0; i < simulated.robot.cables.size(); ++i) {
      const CableSolution& truth = simulated.truth.cables[i].cable;
      EXPECT_EQ(start.lengths[i], truth.length) << name;
      const double weight = simulated.robot.cables[i].properties.weight * truth.length;
      if (truth.tension_a < 10.0 * weight) continue;
      // Half of the weight hangs at A besides the tension along the chord.
      EXPECT_NEAR(std::hypot(start.forces[i].horizontal, start.forces[i].vertical), truth.tension_a, 0.51 * weight)
          << name << ", cable " << i;
    }
  }
}

// From the last pose, an adjustment of lengths alone may end in an equilibrium that no platform would keep.
TEST(ColdStart, FindsThePlatformAgainAfterItMovedFarUnseen) {
  for (const char* name : {"scampi", "caroca", "cogiro"}) {
    SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, name);
    Workspace workspace = workspaceOf(name);
    PoseEstimator estimator(simulated.robot, simulated.estimator);
    for (int moves = 0; moves < 25;) {
      if (!simulated.moveTo(randomPose(workspace, &simulated.dice))) continue;
      ++moves;
      CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
      for (auto& tension : measurements.tensions) tension.reset();
      const Estimate estimate = estimator.update(measurements);
      ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
      EXPECT_LT(poseError(estimate.solution.pose, simulated.truth.pose).norm(), 1e-6) << name << ", move " << moves;
    }
  }
}

TEST(ColdStart, RecoversFromABadSeed) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  PoseEstimator estimator(simulated.robot, simulated.estimator);
  Pose seed = simulated.truth.pose;
  seed.position += Eigen::Vector3d(1.0, -0.8, 0.5);
  seed.orientation = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()) * seed.orientation;
  estimator.setPose(seed);
  const Estimate estimate = estimator.update(simulated.measure(simulated.truth, 0.0));
  ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
  EXPECT_LT(poseError(estimate.solution.pose, simulated.truth.pose).norm(), 1e-6);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// One adjustment: exact measurements, the condition of a minimum, and its covariance against drawn noise.
#include "estimation/adjustment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measured_truth.h"

namespace cdpr_kinetostatics {
namespace {

Adjusted adjustAll(const SimulatedRobot& simulated, const CableMeasurements& measurements) {
  const MeasuredRobot measured = measuredBy(simulated, measurements);
  return adjust(measured, truthOf(simulated), measured.available).adjusted;
}

class AdjustedRobot : public testing::TestWithParam<const char*> {};

TEST_P(AdjustedRobot, ExactMeasurementsLeaveNoResiduals) {
  for (const Model model : {Model::kCatenary, Model::kCatenaryCorrected, Model::kBending}) {
    SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, GetParam(), model);
    const Adjusted adjusted = adjustAll(simulated, simulated.measure(simulated.truth, 0.0));
    ASSERT_TRUE(adjusted.status.ok()) << adjusted.status.message;
    EXPECT_LT(adjusted.weighted_squares, 1e-6);
    EXPECT_LT(poseError(adjusted.unknowns.pose, simulated.truth.pose).norm(), 1e-7);
    EXPECT_TRUE(adjusted.stable);
    const int n = static_cast<int>(simulated.robot.cables.size());
    EXPECT_EQ(adjusted.redundancy, n);  // 2 n measurements and the load for the pose and n forces
    ASSERT_EQ(adjusted.observations.size(), static_cast<std::size_t>(2 * n + simulated.robot.freedoms()));
  }
}

// No direction of the unknowns makes the sum of squares smaller: the residuals are across the Jacobian's columns.
TEST_P(AdjustedRobot, IsAMinimumOfTheSumOfSquares) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, GetParam(), Model::kBending);
  for (int k = 0; k < 5; ++k) {
    const Adjusted adjusted = adjustAll(simulated, simulated.measure(simulated.truth, 1.0));
    ASSERT_TRUE(adjusted.status.ok()) << adjusted.status.message;
    Eigen::VectorXd residuals(static_cast<Eigen::Index>(adjusted.observations.size()));
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
      residuals(i) = adjusted.observations[static_cast<std::size_t>(i)].residual;
    }
    const Eigen::VectorXd cosines =
        (adjusted.jacobian.transpose() * residuals).cwiseQuotient(adjusted.jacobian.colwise().norm().transpose());
    // The unknowns have settled to 1e-10 of their size, in units of deviations that are 1e-4 of it.
    EXPECT_LT(cosines.cwiseAbs().maxCoeff(), 1e-3 * residuals.norm());
  }
}

TEST_P(AdjustedRobot, InformationPredictsTheError) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, GetParam());
  constexpr int kDraws = 500;
  const int freedoms = simulated.robot.freedoms();
  double squares = 0.0, weighted = 0.0;
  int redundancy = 0;
  for (int k = 0; k < kDraws; ++k) {
    // The load's own error moves the truth, to which the measurements belong.
    const RobotSolution state = simulated.under(simulated.randomLoad());
    ASSERT_TRUE(state.report.status.ok()) << state.report.status.message;
    const Adjusted adjusted = adjustAll(simulated, simulated.measure(state, 1.0));
    ASSERT_TRUE(adjusted.status.ok()) << adjusted.status.message;
    const Eigen::VectorXd error = poseError(adjusted.unknowns.pose, state.pose).head(freedoms);
    squares += error.dot(adjusted.information * error);
    weighted += adjusted.weighted_squares;
    redundancy = adjusted.redundancy;
  }
  // Means of 500 chi-squares: deviations of sqrt(2/(500 f)), 2.6 % for 6 freedoms, 4.5 % for the point mass's 2 or 3.
  EXPECT_NEAR(squares / kDraws, freedoms, 0.15 * freedoms);
  EXPECT_NEAR(weighted / kDraws, redundancy, 0.15 * redundancy);
}

INSTANTIATE_TEST_SUITE_P(Shipped, AdjustedRobot, testing::Values("cogiro", "ipanema3", "paper_point_mass"));

TEST(Adjustment, HasNoTimeLeftAndSaysSo) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
  const MeasuredRobot measured = measuredBy(simulated, measurements);
  const Adjusted adjusted = adjust(measured.robot, measured.options, measurements, measured.available, measured.rungs,
                                   truthOf(simulated), std::chrono::steady_clock::now() - std::chrono::seconds(1));
  EXPECT_EQ(adjusted.status.code, Code::kTimedOut);
  EXPECT_FALSE(adjusted.status.message.empty());
}

}  // namespace
}  // namespace cdpr_kinetostatics

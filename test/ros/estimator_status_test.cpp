#include "ros/estimator_status.h"

#include <gtest/gtest.h>

namespace cdpr_kinetostatics {
namespace {

Estimate estimateOfTwoCables() {
  Estimate estimate;
  estimate.solution.cables.resize(2);
  estimate.solution.cables[0].name = "left";
  estimate.solution.cables[1].name = "right";
  estimate.length_outlier = {false, true};
  estimate.tension_outlier = {true, false};
  estimate.covariance.diagonal() << 1e-6, 4e-6, 1e-6, 1e-8, 1e-8, 9e-8;
  estimate.load_covariance.diagonal() << 100.0, 25.0, 1e6, 1.0, 4.0, 1.0;
  estimate.load_unknown(2) = true;
  return estimate;
}

KinetostaticState stateOf(std::int32_t code, double solve_time, bool warm_started = false) {
  KinetostaticState state;
  state.report.code = code;
  state.report.solve_time = solve_time;
  state.report.warm_started = warm_started;
  state.report.message = code == SolveReport::CONVERGED ? "" : "no pose explains the measurements";
  return state;
}

TEST(EstimatorStatus, CountsSolvesFailuresAndColdStarts) {
  EstimatorStatus status;
  status.add(estimateOfTwoCables(), stateOf(SolveReport::CONVERGED, 0.003));
  status.add(estimateOfTwoCables(), stateOf(SolveReport::CONVERGED, 0.001, true));
  status.add(Estimate(), stateOf(SolveReport::NOT_CONVERGED, 0.002));
  EXPECT_EQ(status.solves, 3u);
  EXPECT_EQ(status.failures, 1u);
  EXPECT_EQ(status.cold_starts, 1u);
  EXPECT_DOUBLE_EQ(status.recent_solve_time, 0.006);
  EXPECT_EQ(status.largest_solve_time, 0.003);
  EXPECT_EQ(status.last_failure, "no pose explains the measurements");
}

TEST(EstimatorStatus, StartsAnewWithoutForgettingTotals) {
  EstimatorStatus status;
  status.add(Estimate(), stateOf(SolveReport::TIMED_OUT, 0.1));
  status.startAnew();
  EXPECT_EQ(status.recent_solves, 0u);
  EXPECT_EQ(status.recent_failures, 0u);
  EXPECT_EQ(status.recent_solve_time, 0.0);
  EXPECT_EQ(status.largest_solve_time, 0.0);
  EXPECT_EQ(status.solves, 1u);
  EXPECT_EQ(status.failures, 1u);
}

TEST(EstimatorStatus, NamesWhatWasLeftOut) {
  Estimate estimate = estimateOfTwoCables();
  estimate.load_outlier(4) = true;
  EstimatorStatus status;
  status.add(estimate, stateOf(SolveReport::CONVERGED, 0.001));
  EXPECT_EQ(status.outliers, (std::vector<std::string>{"tension of left", "length of right", "known load, torque y"}));
}

TEST(EstimatorStatus, NamesWhatMayBeAtFaultInstead) {
  Estimate estimate = estimateOfTwoCables();
  estimate.length_suspect = {true, false};
  estimate.tension_suspect = {false, false};
  estimate.load_suspect(0) = true;
  estimate.deviation_factors.tensions = 2.5;
  EstimatorStatus status;
  status.add(estimate, stateOf(SolveReport::CONVERGED, 0.001));
  EXPECT_EQ(status.suspects, (std::vector<std::string>{"length of left", "known load, force x"}));
  EXPECT_EQ(status.deviation_factors.tensions, 2.5);
}

TEST(EstimatorStatus, TakesTheLargestDeviationOfWhatIsKnown) {
  EstimatorStatus status;
  status.add(estimateOfTwoCables(), stateOf(SolveReport::CONVERGED, 0.001));
  EXPECT_DOUBLE_EQ(status.position_stddev, 2e-3);
  EXPECT_DOUBLE_EQ(status.rotation_stddev, 3e-4);
  EXPECT_DOUBLE_EQ(status.force_stddev, 10.0);  // not the 1000 N of the unknown component
  EXPECT_DOUBLE_EQ(status.torque_stddev, 2.0);
  EXPECT_EQ(status.unknown_load_components, 1);
}

TEST(EstimatorStatus, AFailureKeepsTheLastEstimate) {
  EstimatorStatus status;
  status.add(estimateOfTwoCables(), stateOf(SolveReport::CONVERGED, 0.001));
  status.add(Estimate(), stateOf(SolveReport::NOT_CONVERGED, 0.001));
  EXPECT_DOUBLE_EQ(status.position_stddev, 2e-3);
  EXPECT_EQ(status.outliers.size(), 2u);
  EXPECT_EQ(status.last.code, SolveReport::NOT_CONVERGED);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// What the report says that the cables' model neglects, against what it does neglect.
#include "estimation/estimate_error.h"

#include <gtest/gtest.h>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "simulated_measurements.h"

namespace cdpr_kinetostatics {
namespace {

// Exact measurements of a robot of bending cables, estimated on a coarser model: the pose is off by what the report
// estimates, to first order.
TEST(EstimateError, IsTheDistanceFromTheBendingEstimate) {
  int compared = 0;
  for (const char* name : {"cogiro", "ipanema3", "desktop_music_wire"}) {
    for (const Model model : {Model::kCatenary, Model::kCatenaryInextensible}) {
      SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, name, Model::kBending);
      const CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
      EstimatorOptions coarse = simulated.estimator;
      coarse.model = model;
      coarse.outlier_threshold = 1e6;  // a coarse model must not pass for a fault here
      PoseEstimator estimator(simulated.robot, coarse);
      const Estimate estimate = estimator.update(measurements);
      ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
      const double shift = (estimate.solution.pose.position - simulated.truth.pose.position).norm();
      if (shift < 1e-6) continue;  // of the order of convergence
      ++compared;
      EXPECT_NEAR(estimate.solution.report.estimated_error, shift, 0.3 * shift) << name << ", " << modelName(model);
    }
  }
  EXPECT_GE(compared, 3);
}

}  // namespace
}  // namespace cdpr_kinetostatics

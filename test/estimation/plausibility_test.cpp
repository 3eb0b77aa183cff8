#include "estimation/plausibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "simulated_measurements.h"

namespace cdpr_kinetostatics {
namespace {

struct Unit {
  const char* name;
  double lengths, tensions;  // the unit's number for 1 m, 1 N
};

class Plausibility : public testing::TestWithParam<std::string> {
 protected:
  SimulatedRobot simulated_ = simulatedRobot(ROBOT_DIR, GetParam());
  const Workspace workspace_ = workspaceOf(GetParam());

  CableMeasurements anywhere() {
    while (!simulated_.moveTo(randomPose(workspace_, &simulated_.dice))) {
    }
    return simulated_.measure(simulated_.truth, 1.0);
  }
};

TEST_P(Plausibility, WrongUnitsAreNamed) {
  for (const Unit& unit : {Unit{"millimetres", 1e3, 1.0}, Unit{"inches", 1.0 / 0.0254, 1.0},
                           Unit{"kilonewtons", 1.0, 1e-3}, Unit{"kilometres", 1e-3, 1.0}}) {
    for (int pose = 0; pose < 20; ++pose) {
      CableMeasurements measurements = anywhere();
      for (auto& length : measurements.lengths) *length *= unit.lengths;
      for (auto& tension : measurements.tensions) *tension *= unit.tensions;
      const Status status = checkPlausible(simulated_.robot, simulated_.estimator, measurements);
      EXPECT_EQ(status.code, Code::kInvalidInput) << unit.name;
      EXPECT_NE(status.message.find(unit.name), std::string::npos) << unit.name << ": " << status.message;
    }
  }
}

// What a fault search can find is not refused: dead cells, a length of nothing, a length a hundred times too long.
TEST_P(Plausibility, SingleFaultsPass) {
  for (int pose = 0; pose < 20; ++pose) {
    const CableMeasurements good = anywhere();
    EXPECT_TRUE(checkPlausible(simulated_.robot, simulated_.estimator, good).ok());
    for (std::size_t i = 0; i < simulated_.robot.cables.size(); ++i) {
      CableMeasurements measurements = good;
      measurements.tensions[i] = 0.0;
      EXPECT_TRUE(checkPlausible(simulated_.robot, simulated_.estimator, measurements).ok()) << i;
      measurements = good;
      *measurements.tensions[i] *= 1e6;
      if (simulated_.robot.cables.size() > 2) {
        EXPECT_TRUE(checkPlausible(simulated_.robot, simulated_.estimator, measurements).ok()) << i;
      }
      for (const double factor : {1e-3, 0.9, 1.1, 100.0}) {
        if (simulated_.robot.cables.size() < 3 && factor == 100.0) continue;  // half of two are not "most"
        measurements = good;
        *measurements.lengths[i] *= factor;
        EXPECT_TRUE(checkPlausible(simulated_.robot, simulated_.estimator, measurements).ok()) << i << " " << factor;
      }
    }
  }
}

TEST_P(Plausibility, AnEstimatorSaysSoAtOnce) {
  CableMeasurements measurements = anywhere();
  for (auto& length : measurements.lengths) *length *= 1e3;
  PoseEstimator estimator(simulated_.robot, simulated_.estimator);
  const Estimate estimate = estimator.update(measurements);
  EXPECT_EQ(estimate.solution.report.status.code, Code::kInvalidInput);
  EXPECT_EQ(estimate.solution.report.iterations, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, Plausibility,
                         testing::Values("cogiro", "ipanema3", "caroca", "desktop_music_wire", "scampi",
                                         "paper_point_mass", "fast"),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace cdpr_kinetostatics

#include "estimation/fault_names.h"

#include <gtest/gtest.h>

namespace cdpr_kinetostatics {
namespace {

TEST(FaultNames, AreThoseOfTheSensors) {
  RobotSolution solution;
  solution.cables.resize(2);
  solution.cables[0].name = "left";
  solution.cables[1].name = "right";
  Eigen::Array<bool, 6, 1> load = Eigen::Array<bool, 6, 1>::Constant(false);
  EXPECT_TRUE(faultNames(solution, {false, false}, {false, false}, load).empty());
  load(2) = load(4) = true;
  EXPECT_EQ(joined(faultNames(solution, {false, true}, {true, true}, load)),
            "tension of left, length of right, tension of right, known load, force z, known load, torque y");
}

}  // namespace
}  // namespace cdpr_kinetostatics

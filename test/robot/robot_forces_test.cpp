// Residuals of a state that is handed from solver to solver, against forces summed and ends computed anew.
#include "robot/robot_forces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

TEST(RobotForces, ResidualsAreWhatTheStateLeavesOpen) {
  Dice dice(31);
  for (const char* name : {"cogiro", "paper_point_mass"}) {
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    RobotForces state;
    state.pose = dice.away(robot.home, 0.1, robot.freedoms() == 6 ? 0.1 : 0.0);
    std::vector<PlaneForces> forces;
    double open = 0.0;
    for (const CableDescription& cable : robot.cables) {
      const Eigen::Vector3d to_b = attachmentInWorld(state.pose, cable.attachment) - cable.anchor;
      const PlaneForces f{dice.uniform(50.0, 100.0), dice.uniform(20.0, 200.0), 1.01 * to_b.norm()};
      forces.push_back(f);
      state.lengths.push_back(f.length);
      state.forces.push_back({f.h, f.v});
      const Eigen::Vector2d end = textbookCatenaryEnd(cable.properties, f);
      open = std::max(open, (end - Eigen::Vector2d(to_b.head<2>().norm(), to_b.z())).norm());
    }
    const Wrench total = totalWrench(robot, Wrench::Zero(), state.pose, forces);
    const Residuals residuals = residualsOf(robot, Wrench::Zero(), Model::kCatenary, state);
    EXPECT_NEAR(residuals.closure, open, 1e-9 * robot.span());
    EXPECT_NEAR(residuals.force, total.head<3>().norm(), 1e-9 * robot.weight());
    EXPECT_NEAR(residuals.moment, robot.freedoms() == 6 ? total.tail<3>().norm() : 0.0, 1e-9 * robot.weight());
  }
}

TEST(RobotForces, AStateThatIsNotFiniteHasNoResiduals) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  RobotForces state;
  state.pose = robot.home;
  state.lengths.assign(8, 9.0);
  state.forces.assign(8, {100.0, std::numeric_limits<double>::quiet_NaN()});
  const Residuals residuals = residualsOf(robot, Wrench::Zero(), Model::kCatenary, state);
  EXPECT_EQ(residuals.closure, 0.0);
  EXPECT_EQ(residuals.force, 0.0);
  EXPECT_EQ(residuals.moment, 0.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

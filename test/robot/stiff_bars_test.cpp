// Platforms on bars: cables so stiff in bending that they push.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "cdpr_kinetostatics/robot/forward.h"
#include "robot_audit.h"
#include "robot_cases.h"
#include "suspended_platform.h"

namespace cdpr_kinetostatics {
namespace {

// Eight bars on a platform of six freedoms, one of them too short or too long: they push and bow. From home, each
// length has a stable pose, near to that of the length before.
TEST(StiffBars, ThatDoNotFitAreSolved) {
  constexpr double kStep = 0.04;  // [m]
  for (const double load : {500.0, 10000.0}) {
    const RobotDescription robot = suspendedPlatform(shippedRobot(ROBOT_DIR, "paper_point_mass"), 4, load);
    for (const Model model : {Model::kBending, Model::kBendingInextensible}) {
      double largest_jump = 0.0;
      int pushing = 0;
      Pose last;
      for (int i = 0; i <= 50; ++i) {
        ForwardRequest request;
        request.lengths.assign(8, 4.5);
        request.lengths[0] = 3.5 + kStep * i;
        SCOPED_TRACE(testing::Message() << modelName(model) << ", " << load << " N, first length "
                                        << request.lengths[0]);
        const RobotSolution solution = solveForward(robot, request, patient(model));
        ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
        if (i % 25 == 0) {
          const RobotAudit found = audit(robot, Wrench::Zero(), solution);
          EXPECT_LT(std::max(found.force, found.moment), 1e-8);
          EXPECT_LT(found.closure, 1e-8 * robot.span());
        }
        for (const CableResult& cable : solution.cables) pushing += cable.condition == Condition::kCompressed ? 1 : 0;
        if (i > 0) largest_jump = std::max(largest_jump, (solution.pose.position - last.position).norm());
        last = solution.pose;
      }
      std::cout << modelName(model) << ", " << load << " N: largest jump " << largest_jump << " m, pushing " << pushing
                << "\n";
      EXPECT_LT(largest_jump, 2.0 * kStep);
      EXPECT_GT(pushing, 50);
    }
  }
}

// Six to ten bars of random stiffness, load and lengths, some hardly and some far from fitting: what is left refused
// says so.
TEST(StiffBars, OfRandomLengthsAreSolved) {
  constexpr int kSolves = 300;
  for (const Model model : {Model::kBending, Model::kBendingInextensible}) {
    Dice dice(9);
    int solved = 0;
    for (int k = 0; k < kSolves; ++k) {
      const int corners = 3 + k % 3;
      const double load = std::exp(dice.uniform(std::log(200.0), std::log(2e4)));
      RobotDescription robot = suspendedPlatform(shippedRobot(ROBOT_DIR, "paper_point_mass"), corners, load);
      const double bending = std::exp(dice.uniform(-4.0, 0.0));
      const double axial = std::exp(dice.uniform(-5.0, 0.0));
      for (CableDescription& cable : robot.cables) {
        cable.properties.bending_stiffness *= bending;
        cable.properties.axial_stiffness *= axial;
      }
      const double spread = std::exp(dice.uniform(std::log(1e-3), std::log(0.3)));
      ForwardRequest request;
      for (int i = 0; i < 2 * corners; ++i) request.lengths.push_back(4.5 * (1.0 + spread * dice.uniform(-1.0, 1.0)));
      const RobotSolution solution = solveForward(robot, request, patient(model));
      ASSERT_TRUE(isFinite(solution));
      if (solution.report.status.ok()) {
        ++solved;
      } else {
        EXPECT_EQ(solution.report.status.code, Code::kNotConverged) << solution.report.status.message;
        EXPECT_FALSE(solution.report.status.message.empty());
      }
    }
    std::cout << modelName(model) << ": solved " << solved << " of " << kSolves << "\n";
    EXPECT_GE(solved, 0.99 * kSolves);
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The robot's linear response against a direct solution of its equations.
#include "robot/linear_robot.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include "cdpr_kinetostatics/robot/forward.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

using Matrix6 = LinearRobot::Stiffness;

// The robot at home by CATENARY, its cables added from the solution.
struct AtHome {
  explicit AtHome(const std::string& name) : robot(shippedRobot(ROBOT_DIR, name)), linear(robot) {
    const RobotSolution inverse = solveInverse(robot, requestFor(robot, robot.home), patient(Model::kCatenary, 1e-11));
    RobotSolverOptions options = patient(Model::kCatenary, 1e-11);
    options.compute_stiffness = true;
    solution = forward(robot, lengthsOf(inverse), inverse.pose, options);
    linear.start(solution.pose);
    for (std::size_t i = 0; i < robot.cables.size(); ++i) {
      const CableResult& cable = solution.cables[i];
      linear.add(cablePlane(robot.cables[i], solution.pose), cable.cable.force_jacobian.leftCols<2>(),
                 cable.cable.horizontal_force, cable.force_on_platform);
    }
  }

  const RobotDescription robot;
  RobotSolution solution;
  LinearRobot linear;
};

TEST(LinearRobot, HasTheSolutionsStiffness) {
  for (const char* name : {"cogiro", "ipanema3", "scampi"}) {
    const AtHome at(name);
    ASSERT_TRUE(at.solution.report.status.ok());
    EXPECT_LT((at.linear.stiffness() - at.solution.stiffness).norm(), 1e-6 * at.solution.stiffness.norm()) << name;
  }
}

TEST(LinearRobot, AWrenchIsBalancedByTheDisplacement) {
  AtHome at("cogiro");
  ASSERT_TRUE(at.linear.factorise());
  Wrench wrench;
  wrench << 3.0, -2.0, 5.0, 0.5, 0.7, -0.4;
  Wrench displacement = at.linear.displacement(wrench);
  EXPECT_EQ(at.linear.lever(), at.robot.lever());
  displacement.tail<3>() /= at.robot.lever();
  EXPECT_LT((at.linear.stiffness() * displacement + wrench).norm(), 1e-9 * wrench.norm());
  Eigen::Matrix<double, 6, 2> two;
  two << wrench, 2.0 * wrench;
  EXPECT_LT((at.linear.displacement(two).col(1) - 2.0 * at.linear.displacement(wrench)).norm(), 1e-15);
}

TEST(LinearRobot, APointMassDoesNotTurn) {
  AtHome at("paper_point_mass");
  // Two bars in the plane y = 0 hold the mass across it by their density alone, which is enough.
  ASSERT_TRUE(at.linear.factorise());
  Wrench wrench;
  wrench << 3.0, 0.2, 5.0, 9.0, 9.0, 9.0;
  const Wrench displacement = at.linear.displacement(wrench);
  EXPECT_EQ(displacement.tail<3>().norm(), 0.0);
  const Eigen::Matrix3d stiffness = at.linear.stiffness().topLeftCorner<3, 3>();
  const Eigen::Vector3d expected = -stiffness.colPivHouseholderQr().solve(wrench.head<3>());
  EXPECT_LT((displacement.head<3>() - expected).norm(), 1e-9 * expected.norm());
}

TEST(LinearRobot, WithoutCablesItIsSingular) {
  for (const char* name : {"cogiro", "paper_point_mass"}) {
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    LinearRobot linear(robot);
    linear.start(robot.home);
    EXPECT_FALSE(linear.factorise()) << name;
  }
}

// Only its weight holds a pendulum: it may turn about the vertical and go anywhere, and it swings back.
TEST(LinearRobot, OpenMotionsAreLeftAlone) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  robot.com = {0.0, 0.0, -0.5};
  LinearRobot linear(robot);
  linear.start(Pose());
  EXPECT_FALSE(linear.factorise());
  ASSERT_TRUE(linear.factoriseWithOpenMotions());
  Wrench wrench;
  wrench << 3.0, -2.0, 5.0, 0.5, 0.7, -0.4;
  Wrench displacement = linear.displacement(wrench);
  displacement.tail<3>() /= linear.lever();
  Wrench expected = Wrench::Zero();
  expected.segment<2>(3) = wrench.segment<2>(3) / (0.5 * robot.weight());
  EXPECT_LT((displacement - expected).norm(), 1e-12);
  linear.start(Pose());
  EXPECT_FALSE(linear.factorise()) << "each factorisation is of the stiffness as it is";
}

TEST(LinearRobot, WhatIsNotFiniteIsNotFactorised) {
  AtHome at("cogiro");
  Eigen::Matrix2d bad = Eigen::Matrix2d::Identity();
  bad(0, 1) = std::nan("");
  at.linear.add(cablePlane(at.robot.cables[0], at.robot.home), bad, 1.0, Eigen::Vector3d::UnitX());
  EXPECT_FALSE(at.linear.factorise());
  EXPECT_FALSE(at.linear.factoriseWithOpenMotions());
}

}  // namespace
}  // namespace cdpr_kinetostatics

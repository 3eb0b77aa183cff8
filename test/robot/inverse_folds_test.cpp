// Inverse kinetostatics where cables would go to the least tension that can hold them: a pose that an independent
// programme on the textbook catenary calls feasible is answered.
#include <gtest/gtest.h>

#include <cmath>

#include "catenary_feasibility.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

// Of the range of each cable's tensions, at both ends.
constexpr double kMargin = 0.01;

// Answered, if only as a pose that the platform would leave, in balance and within its limits.
void expectAnswer(const RobotDescription& robot, const RobotSolution& solution) {
  const Code code = solution.report.status.code;
  EXPECT_TRUE(code == Code::kConverged || code == Code::kUnstable) << solution.report.status.message;
  if (solution.cables.empty()) return;
  const RobotAudit a = audit(robot, Wrench::Zero(), solution);
  EXPECT_LT(a.force, 1e-8);
  EXPECT_LT(a.moment, 1e-8);
  EXPECT_LT(a.above_limit, 1e-8);
  for (std::size_t i = 0; i < solution.cables.size(); ++i) {
    EXPECT_GT(solution.cables[i].cable.tension_a, robot.cables[i].tension_min * (1.0 - 1e-8)) << i;
  }
}

class RandomRobots : public testing::TestWithParam<bool> {
 protected:
  // Robots and poses that can be held; preferred tensions in the middle, low or anywhere.
  void solve(int count, Model model) {
    Dice dice(83);
    for (int found = 0; found < count;) {
      const RobotDescription robot = randomRobot(GetParam(), &dice);
      InverseRequest request;
      request.pose = randomPoseOf(robot, &dice);
      const double most = dice.uniform(0.0, 1.0) < 0.5 ? 0.05 : 1.0;
      for (const CableDescription& cable : robot.cables) {
        request.preferred_tensions.push_back(cable.tension_min +
                                             dice.uniform(0.0, most) * (cable.tension_max - cable.tension_min));
      }
      if (!catenariesCanHold(robot, request.pose, kMargin).value_or(false)) continue;
      SCOPED_TRACE(found);
      ++found;
      expectAnswer(robot, solveInverse(robot, request, patient(model)));
    }
  }
};

TEST_P(RandomRobots, AreSolvedOnCatenaries) { solve(150, Model::kCatenary); }

// Bending lowers least tensions: what catenaries can hold, cables that bend hold too.
TEST_P(RandomRobots, AreSolvedOnCablesThatBend) { solve(60, Model::kBending); }

TEST_P(RandomRobots, AreSolvedByAuto) { solve(60, Model::kAuto); }

TEST_P(RandomRobots, AreSolvedOnLines) { solve(20, Model::kStraightElastic); }

INSTANTIATE_TEST_SUITE_P(TensionMin, RandomRobots, testing::Bool(),
                         [](const auto& zero) { return zero.param ? "zero" : "positive"; });

class Slack : public testing::TestWithParam<Model> {};

INSTANTIATE_TEST_SUITE_P(Models, Slack, testing::Values(Model::kCatenary, Model::kBending, Model::kAuto),
                         [](const auto& model) { return std::string(modelName(model.param)); });

TEST_P(Slack, Ipanema3WithoutLeastTensions) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "ipanema3");
  for (CableDescription& cable : robot.cables) cable.tension_min = 0.0;
  Dice dice(84);
  InverseRequest request;
  request.preferred_tensions.assign(8, 40.0);
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    request.pose.position = i == 0 ? Eigen::Vector3d(0.0, 0.0, 1.3) : dice.inBox({-3.0, -2.0, 0.5}, {3.0, 2.0, 2.0});
    const RobotSolution solution = solveInverse(robot, request, patient(GetParam()));
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    expectAnswer(robot, solution);
  }
}

// The robot of the README, and poses that it can hold.
TEST_P(Slack, EightRopesAroundABoxWithoutLeastTensions) {
  RobotDescription robot;
  robot.mass = 12.5;
  for (const double level : {2.5, 0.0}) {
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-1.0, -1.0), Eigen::Vector2d(1.0, -1.0),
                                          Eigen::Vector2d(1.0, 1.0), Eigen::Vector2d(-1.0, 1.0)}) {
      CableDescription cable;
      cable.name = "cable" + std::to_string(robot.cables.size());
      cable.anchor = {2.0 * corner.x(), 1.5 * corner.y(), level};
      cable.attachment = {0.2 * corner.x(), 0.2 * corner.y(), level > 0.0 ? -0.1 : 0.1};
      cable.properties.axial_stiffness = 4.2e5;
      cable.properties.bending_stiffness = 0.05;
      cable.properties.weight = 0.036 * robot.gravity;
      cable.tension_max = 400.0;
      robot.cables.push_back(cable);
    }
  }
  Dice dice(86);
  for (int found = 0; found < 35;) {
    InverseRequest request;
    request.pose.position = dice.inBox({-1.2, -0.9, 0.5}, {1.2, 0.9, 2.0});
    request.preferred_tensions.assign(8, dice.uniform(0.0, 40.0));
    if (!catenariesCanHold(robot, request.pose, kMargin).value_or(false)) continue;
    SCOPED_TRACE(found);
    ++found;
    expectAnswer(robot, solveInverse(robot, request, patient(GetParam())));
  }
}

// Slack cables end near their least tensions, and none beyond: shorter by a thousandth, every cable has more.
TEST(SlackCables, NoneIsLongerThanAtTheLeastTension) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "ipanema3");
  for (CableDescription& cable : robot.cables) cable.tension_min = 0.0;
  CableSolverOptions options;
  options.model = Model::kCatenary;
  Dice dice(85);
  int near_fold = 0;
  for (int pose = 0; pose < 20; ++pose) {
    InverseRequest request;
    request.pose.position = dice.inBox({-3.0, -2.0, 0.5}, {3.0, 2.0, 2.0});
    for (int i = 0; i < 8; ++i) request.preferred_tensions.push_back(dice.uniform(0.0, 400.0));
    const RobotSolution solution = solveInverse(robot, request, patient(Model::kCatenary, 1e-11));
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    for (std::size_t i = 0; i < 8; ++i) {
      const CableSolution& cable = solution.cables[i].cable;
      const auto tension = [&](double length) {
        return findForces(robot.cables[i].properties, length, cable.x, cable.y, options).tension_a;
      };
      EXPECT_GT(tension(cable.length * (1.0 - 1e-3)), cable.tension_a) << i << ": on the taut side";
      // More length than a few per cent over the chord, and hardly less tension.
      if (tension(cable.length * 1.03) > 0.95 * cable.tension_a) ++near_fold;
    }
  }
  EXPECT_GT(near_fold, 5);
}

TEST(SlackCables, NearlyVerticalBarsWithoutLeastTensions) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "paper_point_mass");
  for (CableDescription& cable : robot.cables) cable.tension_min = 0.0;
  for (const double x : {0.1, 0.5, 9.9}) {
    for (const double z : {-1.0, -4.0, -8.0}) {
      InverseRequest request;
      request.pose.position = {x, 0.0, z};
      request.preferred_tensions.assign(2, 40.0);
      SCOPED_TRACE(testing::Message() << x << " " << z);
      const RobotSolution solution = solveInverse(robot, request, patient(Model::kBending));
      ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
      expectAnswer(robot, solution);
    }
  }
}

// A catenary from (10, 0, 2) pulls sideways with more than the other one can hold straight below its anchor.
TEST(SlackCables, ARefusalNamesTheLeastTension) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "paper_point_mass");
  for (CableDescription& cable : robot.cables) cable.tension_min = 0.0;
  InverseRequest request;
  request.pose.position = {0.0, 0.0, -4.0};
  const RobotSolution solution = solveInverse(robot, request, patient(Model::kCatenary));
  EXPECT_EQ(solution.report.status.code, Code::kInfeasible);
  EXPECT_NE(solution.report.status.message.find("'cable1' least tension that can hold the cable"), std::string::npos)
      << solution.report.status.message;
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Forward kinetostatics with straight cables: balance, closure and what happens to slack cables.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cdpr_kinetostatics/robot/forward.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kBalance = 1e-7;  // of the weight
constexpr int kLoads = 20;

double chord(const CableDescription& cable, const Pose& pose) {
  return (attachmentInWorld(pose, cable.attachment) - cable.anchor).norm();
}

std::vector<double> chords(const RobotDescription& robot, const Pose& pose, double factor) {
  std::vector<double> lengths;
  for (const CableDescription& cable : robot.cables) lengths.push_back(factor * chord(cable, pose));
  return lengths;
}

Wrench unbalanced(const RobotDescription& robot, const ForwardRequest& request, const RobotSolution& solution) {
  std::vector<PlaneForces> forces;
  for (const CableResult& result : solution.cables) {
    forces.push_back({result.cable.horizontal_force, result.cable.vertical_force_a, result.cable.length});
  }
  Wrench wrench = totalWrench(robot, request.external_wrench, solution.pose, forces) / robot.weight();
  if (robot.type == PlatformType::kRigidBody) wrench.tail<3>() /= robot.platformRadius();
  return wrench.head(robot.freedoms()).norm() * Wrench::Unit(0);
}

// T along the line, from (H, V) with half of the cable's weight at each end.
double lineTension(const CableDescription& cable, const CableSolution& solution) {
  return std::hypot(solution.horizontal_force,
                    solution.vertical_force_a - 0.5 * cable.properties.weight * solution.length);
}

Wrench randomLoad(const RobotDescription& robot, double share, Dice* dice) {
  Wrench wrench = Wrench::Zero();
  wrench.head<3>() = share * robot.weight() * dice->direction();
  if (robot.type == PlatformType::kRigidBody) {
    wrench.tail<3>() = 0.3 * share * robot.weight() * robot.platformRadius() * dice->direction();
  } else {
    wrench.y() = 0.0;  // the shipped point mass hangs in a plane
  }
  return wrench;
}

RobotDescription someCables(RobotDescription robot, std::initializer_list<std::size_t> which) {
  std::vector<CableDescription> kept;
  for (const std::size_t i : which) kept.push_back(robot.cables[i]);
  robot.cables = kept;
  return robot;
}

class StraightElastic : public testing::TestWithParam<const char*> {};

TEST_P(StraightElastic, BalancesUnderRandomLoadsAndSlackCablesDoNotPull) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, GetParam());
  const RobotSolverOptions options = patient(Model::kStraightElastic, 1e-10);
  Dice dice(81);
  int slack = 0;
  for (int i = 0; i < kLoads; ++i) {
    SCOPED_TRACE("load " + std::to_string(i));
    ForwardRequest request;
    request.lengths = chords(robot, robot.home, 1.0);
    for (double& length : request.lengths) length *= 1.0 + dice.uniform(-1e-3, 1e-3);
    request.external_wrench = randomLoad(robot, 0.3, &dice);
    const RobotSolution solution = solveForward(robot, request, options);
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    EXPECT_LT(unbalanced(robot, request, solution).norm(), kBalance);
    for (std::size_t k = 0; k < robot.cables.size(); ++k) {
      const CableDescription& cable = robot.cables[k];
      const double strain = chord(cable, solution.pose) / request.lengths[k] - 1.0;
      const double expected = std::max(0.0, cable.properties.axial_stiffness * strain);
      EXPECT_NEAR(lineTension(cable, solution.cables[k].cable), expected, 1e-8 * robot.weight() + 1e-9 * expected);
      slack += strain < 0.0 ? 1 : 0;
    }
  }
  RecordProperty("slack", slack);
}

INSTANTIATE_TEST_SUITE_P(Robots, StraightElastic,
                         testing::Values("cogiro", "caroca", "ipanema3", "desktop_music_wire", "fast", "scampi",
                                         "paper_point_mass"),
                         [](const testing::TestParamInfo<const char*>& each) { return std::string(each.param); });

TEST(StraightElasticForward, ASlackCableCarriesNothingButItsWeight) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  ForwardRequest request;
  request.lengths = chords(robot, robot.home, 1.0);
  request.lengths[2] *= 1.05;
  const RobotSolution solution = solveForward(robot, request, patient(Model::kStraightElastic));
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  const CableResult& slack = solution.cables[2];
  ASSERT_LT(chord(robot.cables[2], solution.pose), request.lengths[2]);
  EXPECT_EQ(slack.cable.horizontal_force, 0.0);
  EXPECT_NEAR(slack.cable.vertical_force_a, 0.5 * robot.cables[2].properties.weight * request.lengths[2], 1e-12);
  EXPECT_EQ(slack.condition, Condition::kSlack);
}

TEST(StraightElasticForward, ComesNearTheCatenaryOfALightCable) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  for (CableDescription& cable : robot.cables) cable.properties.weight *= 1e-3;
  ForwardRequest request;
  request.lengths = chords(robot, robot.home, 0.9995);
  const RobotSolution straight = solveForward(robot, request, patient(Model::kStraightElastic, 1e-10));
  const RobotSolution catenary = solveForward(robot, request, patient(Model::kCatenary, 1e-10));
  ASSERT_TRUE(straight.report.status.ok() && catenary.report.status.ok());
  EXPECT_TRUE(samePose(straight.pose, catenary.pose, 1e-6));
}

TEST(StraightForward, AsManyCablesAsFreedomsCloseExactly) {
  const RobotDescription cogiro = shippedRobot(ROBOT_DIR, "cogiro");
  Dice dice(82);
  for (const RobotDescription& robot :
       {shippedRobot(ROBOT_DIR, "fast"), shippedRobot(ROBOT_DIR, "scampi"), shippedRobot(ROBOT_DIR, "paper_point_mass"),
        someCables(cogiro, {0, 2, 4, 6, 1}), someCables(cogiro, {0, 2, 4})}) {
    for (int i = 0; i < 5; ++i) {
      SCOPED_TRACE(robot.name + " with " + std::to_string(robot.cables.size()) + " cables, load " + std::to_string(i));
      ForwardRequest request;
      request.lengths = chords(robot, robot.home, 1.0);
      request.external_wrench = randomLoad(robot, 0.1, &dice);
      const RobotSolution solution = solveForward(robot, request, patient(Model::kStraight, 1e-10));
      ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
      EXPECT_LT(unbalanced(robot, request, solution).norm(), kBalance);
      for (std::size_t k = 0; k < robot.cables.size(); ++k) {
        const double excess = chord(robot.cables[k], solution.pose) / request.lengths[k] - 1.0;
        const double tension = lineTension(robot.cables[k], solution.cables[k].cable);
        EXPECT_GE(tension, 0.0);
        EXPECT_LT(excess, 1e-9) << "a cable is longer than it is";
        EXPECT_TRUE(tension < 1e-6 * robot.weight() || excess > -1e-9) << "a slack cable pulls";
      }
    }
  }
}

TEST(StraightForward, MoreCablesThanFreedomsGiveTheLeastSquaresPose) {
  Dice dice(83);
  for (const char* name : {"cogiro", "caroca", "ipanema3", "desktop_music_wire"}) {
    SCOPED_TRACE(name);
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    ForwardRequest request;
    request.lengths = chords(robot, dice.away(robot.home, 0.02 * robot.span(), 0.05), 1.0);
    for (double& length : request.lengths) length *= 1.0 + dice.uniform(-1e-3, 1e-3);
    const RobotSolution solution = solveForward(robot, request, patient(Model::kStraight, 1e-10));
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    double largest = 0.0, cost = 0.0;
    // Squares of length errors over length, as springs of one stiffness.
    const auto costAt = [&](const Pose& pose) {
      double sum = 0.0;
      for (std::size_t k = 0; k < robot.cables.size(); ++k) {
        sum += std::pow(chord(robot.cables[k], pose) - request.lengths[k], 2);
      }
      return sum;
    };
    cost = costAt(solution.pose);
    for (int i = 0; i < 50; ++i) {
      EXPECT_GE(costAt(dice.away(solution.pose, 1e-4, 1e-4)), cost * (1.0 - 1e-12));
    }
    for (std::size_t k = 0; k < robot.cables.size(); ++k) {
      EXPECT_GE(lineTension(robot.cables[k], solution.cables[k].cable), 0.0);
      largest = std::max(largest, std::abs(chord(robot.cables[k], solution.pose) - request.lengths[k]));
    }
    EXPECT_NEAR(solution.report.closure_residual, largest, 1e-9);
    // The report's residuals are the imbalance that is left.
    EXPECT_NEAR(std::hypot(solution.report.force_residual, solution.report.moment_residual / robot.platformRadius()),
                robot.weight() * unbalanced(robot, request, solution).norm(), 1e-9 * robot.weight());
  }
}

// Lengths that no pose has: the answer says by how much, or refuses. Whatever is called an answer is in balance.
TEST(StraightForward, LengthsThatContradictEachOtherAreToldSo) {
  Dice dice(84);
  for (const char* name : {"cogiro", "caroca", "ipanema3", "desktop_music_wire"}) {
    SCOPED_TRACE(name);
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    int answered = 0, refused = 0;
    for (const double error : {0.0, 1e-3, 0.01, 0.1}) {
      for (int trial = 0; trial < 20; ++trial) {
        ForwardRequest request;
        request.lengths = chords(robot, dice.away(robot.home, 0.02 * robot.span(), 0.05), 1.0);
        for (double& length : request.lengths) length *= 1.0 + dice.uniform(-error, error);
        const RobotSolution solution = solveForward(robot, request, patient(Model::kStraight));
        const Status& status = solution.report.status;
        EXPECT_TRUE(isFinite(solution));
        if (!status.ok()) {
          ++refused;
          EXPECT_EQ(status.code, Code::kInfeasible) << status.message;
          EXPECT_TRUE(status.message.find("misses by") != std::string::npos ||
                      status.message.find("no tensions") != std::string::npos)
              << status.message;
          continue;
        }
        ++answered;
        EXPECT_LT(robot.weight() * unbalanced(robot, request, solution).norm(), 1e-5 * robot.weight());
        double miss = 0.0;
        for (const CableResult& cable : solution.cables) {
          miss = std::max(miss, cable.cable.closure_residual / cable.cable.length);
        }
        EXPECT_LT(miss, 0.03);
        EXPECT_EQ(status.message.find("misses by") != std::string::npos, error > 0.0) << status.message;
        EXPECT_GE(solution.report.closure_residual, 0.0);
      }
    }
    EXPECT_GT(answered, 10);
    EXPECT_GT(refused, 5);
  }
}

// All cables end at the platform's origin, where no moment can be balanced but that of a weight without an arm: the
// radius is zero, and moments still count.
TEST(StraightForward, CablesThatMeetAtTheOriginBalanceTheForce) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  robot.mass = 10.0;
  robot.com.setZero();
  for (CableDescription& cable : robot.cables) cable.attachment.setZero();
  ASSERT_EQ(robot.platformRadius(), 0.0);
  for (const double factor : {1.0, 0.999}) {
    ForwardRequest request;
    request.lengths = chords(robot, robot.home, factor);
    const RobotSolution solution = solveForward(robot, request, patient(Model::kStraight, 1e-10));
    EXPECT_TRUE(isFinite(solution));
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    EXPECT_LT(solution.report.force_residual, 1e-6 * robot.weight()) << factor;
    EXPECT_LT(solution.report.moment_residual, 1e-6 * robot.weight()) << factor;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

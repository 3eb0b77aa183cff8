// Robots at extremes: slack cables among taut ones, the workspace's border, the load limit, singular poses, vertical
// cables, tiny and huge forces and sizes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <utility>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot/platform_statics.h"
#include "robot_audit.h"
#include "robot_cases.h"
#include "scaled_robot.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kPoseTolerance = 1e-6;  // over the span, and [rad]
constexpr Model kModels[] = {Model::kCatenary, Model::kAuto, Model::kBending};

// AUTO's inverse and forward solutions may each be its accuracy away.
bool isBack(const RobotDescription& robot, const RobotSolverOptions& options, const Pose& a, const Pose& b) {
  const double allowed = kPoseTolerance * robot.span() + (options.model == Model::kAuto ? 2.0 * options.accuracy : 0.0);
  return (a.position - b.position).norm() < allowed &&
         a.orientation.angularDistance(b.orientation) * std::min(robot.span(), robot.platformRadius()) < allowed;
}

void expectEquilibrium(const RobotDescription& robot, const Wrench& external, const RobotSolution& solution) {
  const RobotAudit found = audit(robot, external, solution);
  EXPECT_LT(found.force, 1e-8);
  EXPECT_LT(found.moment, 1e-8);
  EXPECT_LT(found.closure, 1e-8 * robot.span());
}

void expectRefused(const RobotSolution& solution, const std::string& words) {
  EXPECT_FALSE(solution.report.status.ok());
  EXPECT_NE(solution.report.status.message.find(words), std::string::npos) << solution.report.status.message;
  EXPECT_TRUE(isFinite(solution));
}

// AUTO keeps its word: BENDING puts the platform within its accuracy.
void expectAccurate(const RobotDescription& robot, const Wrench& external, const RobotSolution& solution,
                    const RobotSolverOptions& options) {
  ForwardRequest request;
  request.lengths = lengthsOf(solution);
  request.external_wrench = external;
  request.seed = solution.pose;
  RobotSolverOptions exact = options;
  exact.model = Model::kBending;
  const RobotSolution bending = solveForward(robot, request, exact);
  ASSERT_TRUE(bending.report.status.ok()) << bending.report.status.message;
  const double turned = bending.pose.orientation.angularDistance(solution.pose.orientation) * robot.platformRadius();
  EXPECT_LT(std::max((bending.pose.position - solution.pose.position).norm(), turned), options.accuracy)
      << solution.report.status.message;
}

// Forward kinetostatics leads back to where inverse kinetostatics came from.
void expectBack(const RobotDescription& robot, const Wrench& external, const RobotSolution& inverse,
                const RobotSolverOptions& options) {
  ForwardRequest request;
  request.lengths = lengthsOf(inverse);
  request.external_wrench = external;
  request.seed = displaced(inverse.pose, 0.02 * robot.span() * Eigen::Vector3d(0.6, -0.8, 0.0),
                           Eigen::Vector3d(0.05, 0.05, -0.05));
  const RobotSolution forward = solveForward(robot, request, options);
  ASSERT_TRUE(forward.report.status.ok()) << forward.report.status.message;
  expectEquilibrium(robot, external, forward);
  if (options.model == Model::kAuto) expectAccurate(robot, external, forward, options);
  EXPECT_TRUE(isBack(robot, options, forward.pose, inverse.pose))
      << forward.pose.position.transpose() << " instead of " << inverse.pose.position.transpose();
}

class RobotExtremes : public testing::TestWithParam<Model> {
 protected:
  const RobotSolverOptions options_ = patient(GetParam());
};

TEST_P(RobotExtremes, SlackCablesAmongTautOnes) {
  int slack = 0;
  int solved = 0;
  int asked = 0;
  for (const char* name : {"cogiro", "caroca", "ipanema3"}) {
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    const std::vector<double> lengths = lengthsOf(solveInverse(robot, requestFor(robot, robot.home), options_));
    ASSERT_EQ(lengths.size(), robot.cables.size());
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      for (const double excess : {0.02, 0.1, 0.5}) {
        SCOPED_TRACE(testing::Message() << name << ", cable " << i << " longer by " << excess);
        ForwardRequest request;
        request.lengths = lengths;
        request.lengths[i] *= 1.0 + excess;
        const RobotSolution solution = solveForward(robot, request, options_);
        ++asked;
        EXPECT_TRUE(isFinite(solution));
        EXPECT_TRUE(solution.report.status.ok()) << solution.report.status.message;
        if (!solution.report.status.ok()) continue;
        ++solved;
        expectEquilibrium(robot, Wrench::Zero(), solution);
        if (GetParam() == Model::kAuto) expectAccurate(robot, Wrench::Zero(), solution, options_);
        for (const CableResult& cable : solution.cables) slack += cable.condition == Condition::kSlack ? 1 : 0;
      }
    }
  }
  std::cout << "solved " << solved << " of " << asked << ", slack cables " << slack << "\n";
  EXPECT_GT(slack, asked / 2);
}

// Along rays from home, by bisection: the last pose with tensions within limits has one at its limit.
TEST_P(RobotExtremes, BorderOfTheWorkspace) {
  Dice dice(3);
  for (const char* name : {"cogiro", "caroca", "ipanema3"}) {
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    for (int k = 0; k < 6; ++k) {
      const Eigen::Vector3d ray = robot.span() * dice.direction();
      const auto at = [&](double share) {
        Pose pose = robot.home;
        pose.position += share * ray;
        return solveInverse(robot, requestFor(robot, pose), options_);
      };
      double inside = 0.0;
      double outside = 1.0;
      RobotSolution last = at(inside);
      for (int i = 0; i < 40; ++i) {
        const double share = 0.5 * (inside + outside);
        const RobotSolution solution = at(share);
        SCOPED_TRACE(testing::Message() << name << ", ray " << ray.transpose() << ", share " << share);
        EXPECT_TRUE(solution.report.status.ok() || solution.report.status.code == Code::kInfeasible)
            << solution.report.status.message;
        (solution.report.status.ok() ? inside : outside) = share;
        if (solution.report.status.ok()) last = solution;
      }
      SCOPED_TRACE(testing::Message() << name << ", ray " << ray.transpose() << ", border at " << inside);
      ASSERT_TRUE(last.report.status.ok()) << last.report.status.message;
      double nearest = 1.0;
      const std::vector<double> tensions = tensionsOf(last);
      for (std::size_t i = 0; i < tensions.size(); ++i) {
        const CableDescription& cable = robot.cables[i];
        nearest = std::min({nearest, std::abs(tensions[i] / cable.tension_min - 1.0),
                            std::abs(tensions[i] / cable.tension_max - 1.0)});
      }
      EXPECT_LT(nearest, 1e-6);
      expectBack(robot, Wrench::Zero(), last, options_);
    }
  }
}

TEST_P(RobotExtremes, LoadAtTheTensionLimit) {
  for (const char* name : {"cogiro", "caroca", "ipanema3"}) {
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    SCOPED_TRACE(name);
    const auto at = [&](double load) {
      InverseRequest request = requestFor(robot, robot.home);
      request.external_wrench.z() = -load;
      return solveInverse(robot, request, options_);
    };
    double low = 0.0;
    double high = 1e3 * robot.weight();
    for (int i = 0; i < 40; ++i) (at(0.5 * (low + high)).report.status.ok() ? low : high) = 0.5 * (low + high);
    const RobotSolution last = at(low);
    ASSERT_TRUE(last.report.status.ok()) << last.report.status.message;
    double largest = 0.0;
    for (const CableResult& cable : last.cables) {
      largest = std::max(largest, cable.cable.tension_a / robot.cables[0].tension_max);
    }
    EXPECT_NEAR(largest, 1.0, 1e-6);
    expectRefused(at(1.001 * high), "tension_max");
    Wrench external = Wrench::Zero();
    external.z() = -low;
    expectBack(robot, external, last, options_);
  }
}

TEST_P(RobotExtremes, APointMassInTheHorizontalPlaneOfItsCables) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "paper_point_mass");
  const CableDescription like = robot.cables[0];
  robot.cables.clear();
  for (int i = 0; i < 3; ++i) {
    CableDescription cable = like;
    cable.name = "cable" + std::to_string(i);
    cable.anchor = 5.0 * Eigen::Vector3d(std::cos(2.0 * M_PI * i / 3.0), std::sin(2.0 * M_PI * i / 3.0), 0.0);
    cable.properties.weight = 0.0;
    cable.properties.bending_stiffness = 0.0;
    robot.cables.push_back(cable);
  }
  robot.home.position.setZero();
  InverseRequest request = requestFor(robot, robot.home);
  expectRefused(solveInverse(robot, request, options_), "cannot balance");
  // Cables of exactly the anchors' distance stretch until they hold the mass: T = EA (1/cos - 1), 3 T sin = weight.
  ForwardRequest forward;
  forward.lengths = {5.0, 5.0, 5.0};
  const RobotSolution solution = solveForward(robot, forward, options_);
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  const double angle = std::atan2(-solution.pose.position.z(), 5.0);
  EXPECT_NEAR(3.0 * like.properties.axial_stiffness * (1.0 / std::cos(angle) - 1.0) * std::sin(angle) / robot.weight(),
              1.0, 1e-6);
}

// All cables end in one point, the centre of mass or one above it: nothing resists a rotation, or one about the
// vertical. That is an answer, with the motions that are open named.
TEST_P(RobotExtremes, APlatformThatTurnsFreely) {
  const RobotDescription like = shippedRobot(ROBOT_DIR, "cogiro");
  const Eigen::Vector3d offset(0.1, -0.2, 0.3);
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  for (const auto& [attachment, com] :
       {std::pair{none, none}, std::pair{offset, offset}, std::pair{none, Eigen::Vector3d(0.0, 0.0, -0.4)}}) {
    SCOPED_TRACE(testing::Message() << "cables end at " << attachment.transpose() << ", com " << com.transpose());
    RobotDescription robot = like;
    robot.com = com;
    for (CableDescription& cable : robot.cables) cable.attachment = attachment;
    ForwardRequest request;
    for (const CableDescription& cable : robot.cables) {
      request.lengths.push_back((robot.home.position + attachment - cable.anchor).norm());
    }
    const RobotSolution solution = solveForward(robot, request, options_);
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    EXPECT_NE(solution.report.status.message.find("turns about"), std::string::npos) << solution.report.status.message;
    EXPECT_LT((solution.pose.position - robot.home.position).norm(), 0.5);
    expectEquilibrium(robot, Wrench::Zero(), solution);
  }
}

TEST_P(RobotExtremes, CablesVerticalAndNearlySo) {
  const RobotDescription like = shippedRobot(ROBOT_DIR, "cogiro");
  for (const double aside : {0.0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2}) {
    SCOPED_TRACE(testing::Message() << "attachments " << aside << " m beside the vertical");
    RobotDescription robot = like;
    robot.cables.resize(4);
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d corner(i < 2 ? 1.0 : -1.0, i % 2 == 0 ? 1.0 : -1.0, 0.0);
      robot.cables[i].anchor = corner + Eigen::Vector3d(0.0, 0.0, 5.0);
      robot.cables[i].attachment = (1.0 + aside) * corner;
    }
    robot.com.setZero();
    robot.home = Pose();
    InverseRequest request = requestFor(robot, robot.home);
    request.free_orientation = true;
    const RobotSolution inverse = solveInverse(robot, request, options_);
    EXPECT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    if (!inverse.report.status.ok()) continue;
    expectEquilibrium(robot, Wrench::Zero(), inverse);
    expectBack(robot, Wrench::Zero(), inverse, options_);
  }
}

// Not mere changes of units: bending stiffness grows a hundredfold beside them, and weight falls to a tenth.
TEST_P(RobotExtremes, TinyAndHugeForcesAndSizes) {
  for (const Workspace& workspace : shippedWorkspaces()) {
    const RobotDescription own = shippedRobot(ROBOT_DIR, workspace.robot);
    for (const double span : {0.1, 500.0}) {
      for (const double weight : {1e-3, 1e7}) {
        SCOPED_TRACE(testing::Message() << workspace.robot << ", " << span << " m, " << weight << " N");
        const Scale scale{span / own.span(), weight / own.weight()};
        RobotDescription robot = scaled(scale, own);
        for (CableDescription& cable : robot.cables) {
          cable.properties.bending_stiffness *= 100.0;
          cable.properties.weight *= 0.1;
        }
        const RobotSolverOptions options = scaled(scale, options_);
        const RobotSolution inverse = solveInverse(robot, requestFor(robot, robot.home), options);
        ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
        expectEquilibrium(robot, Wrench::Zero(), inverse);
        expectBack(robot, Wrench::Zero(), inverse, options);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, RobotExtremes, testing::ValuesIn(kModels),
                         [](const testing::TestParamInfo<Model>& each) { return modelName(each.param); });

}  // namespace
}  // namespace cdpr_kinetostatics

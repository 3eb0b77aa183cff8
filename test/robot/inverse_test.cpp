// Optimality of inverse kinetostatics, verified by the Karush-Kuhn-Tucker conditions: derivatives are
// differences of wrenches whose cables are solved one by one for their length.
#include "cdpr_kinetostatics/robot/inverse.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <functional>
#include <string>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "robot/platform_statics.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kOptimal = 1e-5;  // imbalance of the multipliers, relative to the gradient

RobotDescription withCables(RobotDescription robot, std::size_t count) {
  // Alternate ones first, so that few cables still surround the platform.
  std::vector<CableDescription> kept;
  for (std::size_t i = 0; i < count; ++i)
    kept.push_back(robot.cables[robot.cables.size() > 4 ? (2 * i) % 8 + (2 * i) / 8 : i]);
  robot.cables = kept;
  return robot;
}

Wrench wrenchWith(const RobotDescription& robot, const Pose& pose, const std::vector<double>& tensions,
                  const std::vector<double>& hints, Model model) {
  CableSolverOptions options;
  options.model = model;
  options.tolerance = 1e-10;
  std::vector<PlaneForces> forces;
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    const Eigen::Vector3d to_b = attachmentInWorld(pose, robot.cables[i].attachment) - robot.cables[i].anchor;
    const CableSolution cable =
        findLength(robot.cables[i].properties, to_b.head<2>().norm(), to_b.z(), tensions[i], hints[i], options);
    EXPECT_TRUE(cable.status.ok()) << cable.status.message;
    forces.push_back({cable.horizontal_force, cable.vertical_force_a, cable.length});
  }
  Wrench wrench = totalWrench(robot, Wrench::Zero(), pose, forces);
  wrench.tail<3>() /= std::max(robot.platformRadius(), 1e-3);
  return wrench;
}

// Gradient of the objective = (d wrench)^T multipliers + limits' multipliers of the right sign.
void expectOptimal(const RobotDescription& robot, const InverseRequest& request, const RobotSolution& solution,
                   Model model, int* at_limits) {
  const std::vector<double> tensions = tensionsOf(solution);
  const std::vector<double> lengths = lengthsOf(solution);
  const auto n = static_cast<Eigen::Index>(tensions.size());
  const Eigen::Index variables = n + (request.free_orientation ? 3 : 0);
  Eigen::MatrixXd derivative(6, variables);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(variables);
  std::vector<Eigen::VectorXd> limits;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const CableDescription& cable = robot.cables[k];
    const double range = cable.tension_max - cable.tension_min;
    const double preferred = request.preferred_tensions.empty() ? 0.5 * (cable.tension_max + cable.tension_min)
                                                                : request.preferred_tensions[k];
    // Variables are shares of the range.
    gradient(i) = 2.0 * (tensions[k] - preferred) / range;
    std::vector<double> more = tensions, less = tensions;
    const double h = 1e-4 * tensions[k];
    more[k] += h;
    less[k] -= h;
    derivative.col(i) = range *
                        (wrenchWith(robot, solution.pose, more, lengths, model) -
                         wrenchWith(robot, solution.pose, less, lengths, model)) /
                        (2.0 * h);
    if (tensions[k] < cable.tension_min * (1.0 + 1e-6)) limits.push_back(Eigen::VectorXd::Unit(variables, i));
    if (tensions[k] > cable.tension_max * (1.0 - 1e-6)) limits.push_back(-Eigen::VectorXd::Unit(variables, i));
  }
  for (Eigen::Index i = n; i < variables; ++i) {
    const Eigen::Vector3d turn = 1e-5 * Eigen::Vector3d::Unit(i - n);
    const Pose more = displaced(solution.pose, Eigen::Vector3d::Zero(), turn);
    const Pose less = displaced(solution.pose, Eigen::Vector3d::Zero(), -turn);
    derivative.col(i) =
        (wrenchWith(robot, more, tensions, lengths, model) - wrenchWith(robot, less, tensions, lengths, model)) / 2e-5;
  }
  const int rows = robot.freedoms();
  Eigen::MatrixXd directions(variables, rows + static_cast<Eigen::Index>(limits.size()));
  directions.leftCols(rows) = derivative.topRows(rows).transpose() / robot.weight();
  for (std::size_t k = 0; k < limits.size(); ++k) {
    directions.col(rows + static_cast<Eigen::Index>(k)) = limits[k];
  }
  const Eigen::VectorXd multipliers = directions.colPivHouseholderQr().solve(gradient);
  EXPECT_LT((directions * multipliers - gradient).norm(), kOptimal * gradient.norm());
  for (Eigen::Index k = rows; k < multipliers.size(); ++k) EXPECT_GT(multipliers(k), -kOptimal * gradient.norm());
  *at_limits += static_cast<int>(limits.size());
}

struct Case {
  const char* robot;
  std::size_t cables;
  bool free_orientation;
  Model model;
};

class InverseOptimality : public testing::TestWithParam<Case> {
 protected:
  InverseOptimality() {
    if (robot_.cables.size() > GetParam().cables) robot_ = withCables(robot_, GetParam().cables);
  }

  // Preferred tensions of cable i, as a share of its limits' range; none: the middle of the limits.
  using Shares = std::function<double(std::size_t i, Dice* dice)>;

  // Solves random poses; returns how many tensions ended at a limit.
  int solve(const Shares& shares, int poses) {
    Dice dice(71);
    int at_limits = 0;
    int done = 0;
    for (int tried = 0; done < poses && tried < 400; ++tried) {
      InverseRequest request;
      request.pose = randomPose(workspace_, &dice);
      request.free_orientation = GetParam().free_orientation;
      for (std::size_t i = 0; i < robot_.cables.size() && shares; ++i) {
        const CableDescription& cable = robot_.cables[i];
        request.preferred_tensions.push_back(cable.tension_min +
                                             shares(i, &dice) * (cable.tension_max - cable.tension_min));
      }
      const RobotSolution solution = solveInverse(robot_, request, patient(GetParam().model, 1e-11));
      const Code code = solution.report.status.code;
      if (code == Code::kInfeasible) continue;
      SCOPED_TRACE("pose " + std::to_string(tried));
      if (code == Code::kUnstable) {
        EXPECT_GT(largestStiffness(robot_, solution, GetParam().model), 0.0);
      } else if (!solution.report.status.ok()) {
        ADD_FAILURE() << solution.report.status.message;
        break;
      }
      ++done;
      const RobotAudit a = audit(robot_, Wrench::Zero(), solution);
      EXPECT_LT(a.force, 1e-9);
      EXPECT_LT(a.moment, 1e-9);
      EXPECT_LT(a.below_limit, 1e-8);
      EXPECT_LT(a.above_limit, 1e-8);
      EXPECT_EQ(solution.pose.position, request.pose.position);
      EXPECT_TRUE(request.free_orientation ||
                  solution.pose.orientation.angularDistance(request.pose.orientation) < 1e-12);
      expectOptimal(robot_, request, solution, GetParam().model, &at_limits);
    }
    EXPECT_EQ(done, poses) << "feasible poses";
    return at_limits;
  }

  const Workspace workspace_ = workspaceOf(GetParam().robot);
  RobotDescription robot_ = shippedRobot(ROBOT_DIR, GetParam().robot);
};

TEST_P(InverseOptimality, TowardsTheMiddleOfTheLimits) { solve(nullptr, 5); }

TEST_P(InverseOptimality, TowardsLowTensionsEachItsOwn) {
  solve([](std::size_t, Dice* dice) { return dice->uniform(0.0, 0.1); }, 5);
}

TEST_P(InverseOptimality, TowardsTensionsThatPushIntoTheLimits) {
  const int at_limits = solve([](std::size_t, Dice* dice) { return dice->uniform(0.0, 1.0) < 0.5 ? 0.0 : 0.8; }, 10);
  EXPECT_TRUE(robot_.cables.size() < 8 || at_limits > 0);
}

TEST_P(InverseOptimality, DoesNotDependOnTheSeedOfTheAttitude) {
  if (!GetParam().free_orientation || GetParam().cables > 4) GTEST_SKIP() << "the attitude is given, or free";
  Dice dice(72);
  InverseRequest request;
  request.free_orientation = true;
  RobotSolution level;
  for (int tried = 0; tried < 50 && !level.report.status.ok(); ++tried) {
    request.pose.position = dice.inBox(workspace_.low, workspace_.high);
    level = solveInverse(robot_, request, patient(GetParam().model));
  }
  ASSERT_TRUE(level.report.status.ok()) << level.report.status.message;
  for (int i = 0; i < 5; ++i) {
    request.pose.orientation = Eigen::AngleAxisd(0.2, dice.direction());
    const RobotSolution turned = solveInverse(robot_, request, patient(GetParam().model));
    ASSERT_TRUE(turned.report.status.ok()) << turned.report.status.message;
    EXPECT_LT(turned.pose.orientation.angularDistance(level.pose.orientation), 1e-6) << "seed " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Robots, InverseOptimality,
    testing::Values(Case{"cogiro", 8, false, Model::kCatenary}, Case{"cogiro", 8, false, Model::kBending},
                    Case{"caroca", 8, false, Model::kCatenary}, Case{"caroca", 8, false, Model::kBending},
                    Case{"ipanema3", 8, false, Model::kCatenary}, Case{"ipanema3", 8, false, Model::kBending},
                    Case{"desktop_music_wire", 8, false, Model::kBending}, Case{"fast", 6, false, Model::kCatenary},
                    Case{"cogiro", 8, true, Model::kCatenary}, Case{"scampi", 4, true, Model::kCatenary},
                    Case{"scampi", 4, true, Model::kBending}, Case{"scampi", 3, true, Model::kCatenary},
                    Case{"cogiro", 5, true, Model::kCatenary}, Case{"cogiro", 5, true, Model::kBending}),
    [](const testing::TestParamInfo<Case>& each) {
      return std::string(each.param.robot) + std::to_string(each.param.cables) +
             (each.param.free_orientation ? "free_" : "_") + modelName(each.param.model);
    });

}  // namespace
}  // namespace cdpr_kinetostatics

// Robots with guide pulleys and dead lengths: round trips, forces summed anew from geometry, stiffness by differences,
// followers and refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/robot/forward_follower.h"
#include "cdpr_kinetostatics/robot/inverse_follower.h"
#include "counted_allocations.h"
#include "geometry/spatial.h"
#include "pulley_robots.h"
#include "robot_audit.h"

namespace cdpr_kinetostatics {
namespace {

// Dead lengths that suit a robot's size, and a radius that is at least some of its ropes' bending layers, sqrt(EI/T): a
// smaller pulley would lift the stiff ropes of CAROCA and SCAMPI off.
RobotDescription onPulleys(const std::string& name) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
  const double size = robot.span();
  const bool stiff_rope = name == "caroca" || name == "scampi";
  return withPulleys(robot, (stiff_rope ? 0.03 : 0.004) * size, 0.5 * size);
}

// The wrench of cables that a single cable's problem 2 solves, at lengths and ends found here, with the weight of the
// free part by formula (41) of docs/theory.md written out.
// known: its answer, for cables that problem 2 alone may not find, near where a stiff rope lifts off.
Wrench wrenchHeldAt(const RobotDescription& robot, const Pose& pose, const std::vector<double>& lengths, Model model,
                    const RobotSolution* known = nullptr) {
  CableSolverOptions options;
  options.model = model;
  options.tolerance = 1e-11;
  Eigen::Vector3d force(0.0, 0.0, -robot.weight());
  Eigen::Vector3d moment = (attachmentInWorld(pose, robot.com) - pose.position).cross(force);
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CableProperties& rope = robot.cables[i].properties;
    const Eigen::Vector3d b = attachmentInWorld(pose, robot.cables[i].attachment);
    const Eigen::Vector3d to_b = b - robot.cables[i].anchor;
    const double x = std::hypot(to_b.x(), to_b.y());
    CableSolution cable = findForces(rope, lengths[i], x, to_b.z(), options);
    if (!cable.status.ok() && known != nullptr) {
      const CableSolution& found = known->cables[i].cable;
      cable = findPosition(rope, found.length, found.horizontal_force, found.vertical_force_a, options);
      EXPECT_LT(std::hypot(cable.x - x, cable.y - to_b.z()), 1e-7 * robot.span());
    }
    EXPECT_TRUE(cable.status.ok()) << cable.status.message;
    const double h = cable.horizontal_force;
    const double v = cable.vertical_force_a;
    const double strain = std::hypot(h, v) / rope.axial_stiffness;
    const double sense = rope.pulley.rope_from == RopeFrom::kBelow ? 1.0 : -1.0;
    const double wrapped = rope.pulley.radius * (M_PI / 2 - sense * cable.angle_a);
    const double on_pulley = (h * std::cos(cable.angle_a) - v * std::sin(cable.angle_a)) / rope.axial_stiffness;
    const double free = cable.length + rope.dead_length * strain / (1.0 + strain) - wrapped / (1.0 + on_pulley);
    const Eigen::Vector3d pull(-h * to_b.x() / x, -h * to_b.y() / x, v - rope.weight * free);
    force += pull;
    moment += (b - pose.position).cross(pull);
  }
  Wrench total;
  total << force, moment;
  return total;
}

class PulleyRobots : public testing::TestWithParam<std::tuple<const char*, Model>> {
 protected:
  const Workspace workspace_ = workspaceOf(std::get<0>(GetParam()));
  const RobotDescription robot_ = onPulleys(std::get<0>(GetParam()));
  const Model model_ = std::get<1>(GetParam());
};

TEST_P(PulleyRobots, ForwardUndoesInverseAndForcesBalance) {
  const RobotSolverOptions options = patient(model_);
  const int poses = model_ == Model::kCatenary || model_ == Model::kBending ? 200 : 40;
  Dice dice(20261101);
  Dice seeds(3);
  int feasible = 0;
  int elsewhere = 0;
  for (int tried = 0; feasible < poses && tried < 10 * poses; ++tried) {
    const Pose pose = randomPose(workspace_, &dice);
    const RobotSolution inverse = solveInverse(robot_, requestFor(robot_, pose), options);
    if (inverse.report.status.code == Code::kInfeasible) continue;
    SCOPED_TRACE(testing::Message() << "pose " << tried << " at " << pose.position.transpose());
    ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    ++feasible;
    if (feasible % 10 == 0 && model_ != Model::kAuto) {
      const Wrench left = wrenchHeldAt(robot_, inverse.pose, lengthsOf(inverse), model_, &inverse);
      EXPECT_LT(left.head<3>().norm(), 1e-6 * robot_.weight());
      EXPECT_LT(left.tail<3>().norm(), 1e-6 * robot_.weight() * robot_.span());
    }
    ForwardRequest request;
    request.lengths = lengthsOf(inverse);
    request.seed = seeds.away(inverse.pose, 0.03 * robot_.span(), 0.1);
    const RobotSolution forward = solveForward(robot_, request, options);
    ASSERT_TRUE(forward.report.status.ok()) << forward.report.status.message;
    // AUTO may choose other models on the way back: both are within the accuracy.
    const double tolerance = model_ == Model::kAuto ? 2.0 * options.accuracy : 1e-6;
    if (!samePose(forward.pose, inverse.pose, tolerance)) ++elsewhere;
  }
  EXPECT_EQ(feasible, poses);
  EXPECT_LE(elsewhere, std::max(1.0, 0.01 * feasible)) << "a seed so far off may lead to another equilibrium";
}

std::string nameOf(const testing::TestParamInfo<std::tuple<const char*, Model>>& each) {
  return std::string(std::get<0>(each.param)) + "_" + modelName(std::get<1>(each.param));
}

INSTANTIATE_TEST_SUITE_P(All, PulleyRobots,
                         testing::Combine(testing::Values("cogiro", "ipanema3", "scampi"),
                                          testing::Values(Model::kStraightElastic, Model::kCatenary,
                                                          Model::kCatenaryCorrected, Model::kBending, Model::kAuto)),
                         nameOf);

// CAROCA's loose cables leave its pulleys at other equilibria, which seeds from afar may find.
INSTANTIATE_TEST_SUITE_P(StiffRopes, PulleyRobots,
                         testing::Combine(testing::Values("caroca"),
                                          testing::Values(Model::kCatenary, Model::kBending)),
                         nameOf);

class PulleyModels : public testing::TestWithParam<Model> {
 protected:
  RobotSolution heldAtHome(const RobotSolverOptions& options) const {
    return solveInverse(robot_, requestFor(robot_, robot_.home), options);
  }

  const RobotDescription robot_ = onPulleys("cogiro");
};

TEST_P(PulleyModels, StiffnessIsThatOfDifferences) {
  RobotSolverOptions options = patient(GetParam(), 1e-11);
  ForwardRequest request;
  const RobotSolution inverse = heldAtHome(options);
  ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
  request.lengths = lengthsOf(inverse);
  request.seed = inverse.pose;
  options.compute_stiffness = true;
  const RobotSolution solution = solveForward(robot_, request, options);
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  const double step = 1e-6;  // [m], [rad]
  Eigen::Matrix<double, 6, 6> differences;
  for (int k = 0; k < 6; ++k) {
    const Wrench move = step * Wrench::Unit(k);
    const Pose ahead = displaced(solution.pose, move.head<3>(), move.tail<3>());
    const Pose behind = displaced(solution.pose, -move.head<3>(), -move.tail<3>());
    differences.col(k) = (wrenchHeldAt(robot_, ahead, request.lengths, GetParam()) -
                          wrenchHeldAt(robot_, behind, request.lengths, GetParam())) /
                         (2.0 * step);
  }
  EXPECT_LT((differences - solution.stiffness).norm(), 1e-5 * solution.stiffness.norm());
}

TEST_P(PulleyModels, ProfilesRunFromTheDepartureToTheAttachment) {
  RobotSolverOptions options = patient(GetParam());
  options.profile_points = 5;
  const RobotSolution solution = heldAtHome(options);
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CableResult& result = solution.cables[i];
    const Eigen::Vector3d centre =
        robot_.cables[i].anchor + robot_.cables[i].properties.pulley.radius * result.direction;
    EXPECT_NEAR((result.departure - centre).norm(), robot_.cables[i].properties.pulley.radius, 1e-12);
    EXPECT_LT((result.profile.front() - result.departure).norm(), 1e-9);
    EXPECT_LT((result.profile.back() - attachmentInWorld(solution.pose, robot_.cables[i].attachment)).norm(), 1e-6);
    EXPECT_EQ(result.condition, Condition::kTaut);
  }
}

// Along 40 poses, there and back: warm starts, the answers of cold ones, and nothing from the heap the second time.
TEST_P(PulleyModels, FollowersGoOnWithoutTheHeap) {
  const RobotSolverOptions options = patient(GetParam());
  std::vector<InverseRequest> poses;
  std::vector<ForwardRequest> lengths;
  for (int i = 0; i < 40; ++i) {
    Pose pose = robot_.home;
    pose.position.x() += 0.01 * (i < 20 ? i : 40 - i);
    poses.push_back(requestFor(robot_, pose));
    const RobotSolution inverse = solveInverse(robot_, poses.back(), options);
    ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
    ForwardRequest request;
    request.lengths = lengthsOf(inverse);
    lengths.push_back(request);
  }
  ForwardFollower forward(robot_, options);
  InverseFollower inverse(robot_, options);
  for (int round = 0; round < 2; ++round) {
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const long allocations = heapCount().allocations;
      ASSERT_TRUE(forward.solve(lengths[k]).ok());
      ASSERT_TRUE(forward.warmStarted() || round == 0) << k;
      EXPECT_TRUE(heapCount().allocations == allocations || round == 0);
      EXPECT_LT((forward.pose().position - poses[k].pose.position).norm(),
                GetParam() == Model::kAuto ? options.accuracy : 1e-6);
      ASSERT_TRUE(inverse.solve(poses[k]).ok());
      ASSERT_TRUE(inverse.warmStarted() || round == 0) << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rungs, PulleyModels,
                         testing::Values(Model::kStraightElastic, Model::kCatenary, Model::kCatenaryCorrected,
                                         Model::kBending),
                         [](const auto& model) { return std::string(modelName(model.param)); });

// The dead part alone: as much rope again behind an eyelet, which stretches as a real straight piece of it does.
TEST(PulleyRobot, DeadLengthGivesWhatItsStretchGives) {
  const RobotDescription plain = shippedRobot(ROBOT_DIR, "cogiro");
  RobotDescription robot = plain;
  for (CableDescription& cable : robot.cables) cable.properties.dead_length = 10.0;
  const RobotSolverOptions options = patient(Model::kCatenary, 1e-11);
  const RobotSolution without = solveInverse(plain, requestFor(plain, plain.home), options);
  const RobotSolution with = solveInverse(robot, requestFor(robot, robot.home), options);
  ASSERT_TRUE(with.report.status.ok() && without.report.status.ok());
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const double strain = with.cables[i].cable.tension_a / robot.cables[i].properties.axial_stiffness;
    const double stretch = 10.0 * strain / (1.0 + strain);
    EXPECT_NEAR(with.cables[i].cable.tension_a, without.cables[i].cable.tension_a, 1e-5);
    EXPECT_NEAR(without.cables[i].cable.length - with.cables[i].cable.length, stretch, 1e-8);
  }
}

// A bending layer of 80 mm on a radius of 30 mm.
TEST(PulleyRobot, APulleyTooSmallForItsRopeIsInfeasible) {
  const RobotDescription robot = withPulleys(shippedRobot(ROBOT_DIR, "caroca"), 0.03, 0.0);
  const RobotSolution solution = solveInverse(robot, requestFor(robot, robot.home), patient(Model::kBending));
  EXPECT_EQ(solution.report.status.code, Code::kInfeasible);
  EXPECT_NE(solution.report.status.message.find("cable '"), std::string::npos) << solution.report.status.message;
  EXPECT_NE(solution.report.status.message.find("pulley"), std::string::npos) << solution.report.status.message;
}

TEST(PulleyRobot, AnEndThatTheRopeCannotReachIsInfeasible) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  robot.cables[2].properties.pulley = {0.5, RopeFrom::kBelow};
  InverseRequest request = requestFor(robot, robot.home);
  request.pose.position = robot.cables[2].anchor + Eigen::Vector3d(0.7, 0.0, 0.2);
  const RobotSolution solution = solveInverse(robot, request, patient(Model::kCatenary));
  EXPECT_EQ(solution.report.status.code, Code::kInfeasible);
  EXPECT_NE(solution.report.status.message.find("cable 'cable2'"), std::string::npos) << solution.report.status.message;
}

}  // namespace
}  // namespace cdpr_kinetostatics

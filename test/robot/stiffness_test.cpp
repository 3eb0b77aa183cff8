// The platform's stiffness against differences of the total wrench, cables solved one by one at fixed lengths.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <tuple>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot/platform_statics.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kPoses = 4;

// Wrench of the platform held at a pose, by problem 2 of every cable.
Wrench wrenchHeldAt(const RobotDescription& robot, const Wrench& external, const Pose& pose,
                    const std::vector<double>& lengths, Model model) {
  CableSolverOptions options;
  options.model = model;
  options.tolerance = 1e-12;
  std::vector<PlaneForces> forces;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Eigen::Vector3d to_b = attachmentInWorld(pose, robot.cables[i].attachment) - robot.cables[i].anchor;
    const CableSolution cable =
        findForces(robot.cables[i].properties, lengths[i], to_b.head<2>().norm(), to_b.z(), options);
    EXPECT_TRUE(cable.status.ok()) << cable.status.message;
    forces.push_back({cable.horizontal_force, cable.vertical_force_a, lengths[i]});
  }
  return totalWrench(robot, external, pose, forces);
}

// Central differences of sixth order.
Matrix6 differencedStiffness(const RobotDescription& robot, const Wrench& external, const RobotSolution& solution,
                             Model model) {
  constexpr double kWeights[] = {45.0, -9.0, 1.0};
  // Small against the stretch of the least strained cable.
  double strain = 1.0;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    strain = std::min(strain, solution.cables[i].cable.tension_a / robot.cables[i].properties.axial_stiffness);
  }
  const double step = 0.01 * strain * robot.span();
  Matrix6 stiffness = Matrix6::Zero();
  for (int k = 0; k < robot.freedoms(); ++k) {
    const double h = k < 3 ? step : step / robot.platformRadius();
    for (int n = 1; n <= 3; ++n) {
      for (const double sign : {1.0, -1.0}) {
        const Wrench move = sign * n * h * Wrench::Unit(k);
        const Pose moved = displaced(solution.pose, move.head<3>(), move.tail<3>());
        stiffness.col(k) +=
            sign * kWeights[n - 1] / (60.0 * h) * wrenchHeldAt(robot, external, moved, lengthsOf(solution), model);
      }
    }
  }
  return stiffness;
}

class Stiffness : public testing::TestWithParam<std::tuple<const char*, Model>> {
 protected:
  RobotSolution solvedAt(const Pose& pose, const Wrench& external) const {
    const RobotSolverOptions options = patient(model(), 1e-11);
    InverseRequest inverse = requestFor(robot_, pose);
    inverse.external_wrench = external;
    const RobotSolution at = solveInverse(robot_, inverse, options);
    if (!at.report.status.ok()) return at;
    ForwardRequest request;
    request.lengths = lengthsOf(at);
    request.external_wrench = external;
    request.seed = at.pose;
    RobotSolverOptions with_stiffness = options;
    with_stiffness.compute_stiffness = true;
    return solveForward(robot_, request, with_stiffness);
  }

  // Rotations times the platform's radius: entries of one size.
  Matrix6 scaled(const Matrix6& stiffness) const {
    Wrench scale = Wrench::Ones();
    if (robot_.type == PlatformType::kRigidBody) scale.tail<3>().setConstant(1.0 / robot_.platformRadius());
    return scale.asDiagonal() * stiffness * scale.asDiagonal();
  }

  Model model() const { return std::get<1>(GetParam()); }

  const Workspace workspace_ = workspaceOf(std::get<0>(GetParam()));
  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, workspace_.robot);
};

TEST_P(Stiffness, IsTheDerivativeOfTheWrench) {
  Dice dice(61);
  for (int done = 0, tried = 0; done < kPoses && tried < 100; ++tried) {
    // Half of the poses carry a load, whose torque makes the stiffness unsymmetric.
    Wrench external = Wrench::Zero();
    if (done % 2 == 1) {
      external.head<3>() = 0.2 * robot_.weight() * dice.direction();
      external.tail<3>() = 0.1 * robot_.weight() * robot_.platformRadius() * dice.direction();
      if (std::get<0>(GetParam()) == std::string("paper_point_mass")) external.y() = 0.0;
    }
    const RobotSolution solution = solvedAt(randomPose(workspace_, &dice), external);
    if (!solution.report.status.ok()) continue;
    ++done;
    const Matrix6 own = scaled(solution.stiffness);
    const Matrix6 numeric = scaled(differencedStiffness(robot_, external, solution, model()));
    EXPECT_LT((own - numeric).norm(), 1e-6 * own.norm()) << own << "\n\n" << numeric;
  }
}

TEST_P(Stiffness, IsSymmetricAndNegativeDefiniteWithoutTorque) {
  Dice dice(62);
  const int n = robot_.freedoms();
  for (int done = 0, tried = 0; done < kPoses && tried < 100; ++tried) {
    const RobotSolution solution = solvedAt(randomPose(workspace_, &dice), Wrench::Zero());
    if (!solution.report.status.ok()) continue;
    ++done;
    const Eigen::MatrixXd own = scaled(solution.stiffness).topLeftCorner(n, n);
    // Curvature per strained length makes a bending cable's forces very slightly not those of an energy.
    const double asymmetry = isBending(model()) ? 1e-5 : 1e-11;
    EXPECT_LT((own - own.transpose()).norm(), asymmetry * own.norm()) << own;
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (own + own.transpose())).eigenvalues();
    EXPECT_LT(eigenvalues.maxCoeff(), 0.0);
  }
}

TEST_P(Stiffness, IsGivenOnlyOnRequestAndOnlyInTheFreedoms) {
  Dice dice(63);
  Pose pose = robot_.home;
  const RobotSolution solution = solvedAt(pose, Wrench::Zero());
  ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
  if (robot_.freedoms() == 3) {
    EXPECT_EQ(solution.stiffness.rightCols<3>().norm(), 0.0);
    EXPECT_EQ(solution.stiffness.bottomRows<3>().norm(), 0.0);
  }
  ForwardRequest request;
  request.lengths = lengthsOf(solution);
  EXPECT_EQ(solveForward(robot_, request, patient(model())).stiffness.norm(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Robots, Stiffness,
                         testing::Combine(testing::Values("cogiro", "desktop_music_wire", "scampi", "paper_point_mass"),
                                          testing::Values(Model::kCatenary, Model::kBending)),
                         [](const testing::TestParamInfo<std::tuple<const char*, Model>>& each) {
                           return std::string(std::get<0>(each.param)) + "_" + modelName(std::get<1>(each.param));
                         });

}  // namespace
}  // namespace cdpr_kinetostatics

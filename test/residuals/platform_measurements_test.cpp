// The block of a platform's measurements: gradients for every model, and the residuals that its header states.
#include "residuals/platform_measurements.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <tuple>

#include "geometry/spatial.h"
#include "robot/residual_blocks.h"
#include "robot_audit.h"
#include "robot_cases.h"
#include "robot_residuals.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-11;
constexpr double kLengthDeviation = 2e-3;
constexpr double kTensionDeviation = 4.0;

struct Case {
  RobotDescription robot;
  RobotSolution truth;
  Wrench load_weight;
  std::vector<PlatformMeasurements::Cable> cables;
  ParameterBlocks parameters;
};

// A robot in equilibrium at a random pose; measured is what its solution says plus offsets, but for every third length
// and every fourth tension, which are not measured.
Case randomCase(const std::string& name, Model model, Dice* dice) {
  Case c;
  c.robot = shippedRobot(ROBOT_DIR, name);
  const Workspace workspace = workspaceOf(name);
  do {
    c.truth = solveInverse(c.robot, requestFor(c.robot, randomPose(workspace, dice)), patient(model, kTolerance));
  } while (!c.truth.report.status.ok());
  for (int k = 0; k < 6; ++k) c.load_weight(k) = k == 1 ? 0.0 : dice->uniform(0.01, 0.1);
  Eigen::VectorXd densities(static_cast<Eigen::Index>(c.robot.cables.size()));
  for (std::size_t i = 0; i < c.robot.cables.size(); ++i) {
    const CableDescription& cable = c.robot.cables[i];
    const CableSolution& solved = c.truth.cables[i].cable;
    SaggingCable start(cable.properties, model, kTolerance);
    start.start(solved.length, {solved.horizontal_force, solved.vertical_force_a});
    c.cables.push_back({cable.anchor, cable.attachment, start, {}, {}});
    if (i % 3 != 2) c.cables.back().length = {solved.length + 0.01 * static_cast<double>(i), kLengthDeviation};
    if (i % 4 != 3) c.cables.back().tension = {solved.tension_a - 2.0 * static_cast<double>(i), kTensionDeviation};
    const Eigen::Vector3d to_b = attachmentInWorld(c.truth.pose, cable.attachment) - cable.anchor;
    densities(static_cast<Eigen::Index>(i)) = solved.horizontal_force / to_b.head<2>().norm();
  }
  c.parameters = {c.truth.pose.position, c.truth.pose.orientation.coeffs(), densities};
  return c;
}

class PlatformMeasurementsBlock : public testing::TestWithParam<std::tuple<const char*, Model>> {
 protected:
  Case next() { return randomCase(std::get<0>(GetParam()), std::get<1>(GetParam()), &dice_); }
  Dice dice_{61};
};

TEST_P(PlatformMeasurementsBlock, PassesTheGradientChecker) {
  for (int i = 0; i < 3; ++i) {
    Case c = next();
    // Away from equilibrium, as an adjustment's iterations are.
    c.parameters[0] += 1e-3 * c.robot.span() * dice_.direction();
    c.parameters[2] *= 1.1;
    const PlatformMeasurements block(platformOf(c.robot, Wrench::Zero()), c.cables, c.load_weight, {kTolerance});
    const CheckedJacobians checked = checkedJacobians(block, c.parameters);
    ASSERT_TRUE(checked.valid) << "state " << i;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == 1 && c.robot.type == PlatformType::kPointMass) continue;  // the orientation has no meaning
      const double largest = checked.own[k].cwiseAbs().maxCoeff();
      EXPECT_LT(largestDifference(checked.own[k], checked.numeric[k], 1e-6 * largest), 2e-5)
          << "state " << i << ", block " << k;
    }
  }
}

TEST_P(PlatformMeasurementsBlock, HasTheJacobianOfCentralDifferences) {
  Case c = next();
  const PlatformMeasurements block(platformOf(c.robot, Wrench::Zero()), c.cables, c.load_weight, {kTolerance});
  const Evaluation own = evaluate(block, c.parameters);
  ASSERT_TRUE(own.valid && own.finite());
  for (const std::size_t k : {0, 2}) {
    // Shorter steps show the rounding of stiff cables' shots, which grows as they shrink.
    Eigen::VectorXd steps = Eigen::VectorXd::Constant(c.parameters[k].size(), 5e-5 * c.robot.span());
    if (k == 2) steps = 5e-3 * c.parameters[k].cwiseAbs();
    const Eigen::MatrixXd numeric = differences(block, c.parameters, k, steps);
    EXPECT_LT(largestDifference(own.jacobians[k], numeric, 1e-6 * numeric.cwiseAbs().maxCoeff()), 2e-5) << k;
  }
}

TEST_P(PlatformMeasurementsBlock, ResidualsAreThoseOfTheHeader) {
  const Case c = next();
  Wrench external;
  external << 3.0, -2.0, 5.0, 1.0, -1.0, 2.0;
  const PlatformMeasurements block(platformOf(c.robot, external), c.cables, c.load_weight, {kTolerance});
  std::vector<double> expected;
  std::vector<PlaneForces> forces;
  for (std::size_t i = 0; i < c.cables.size(); ++i) {
    const CableSolution& solved = c.truth.cables[i].cable;
    forces.push_back({solved.horizontal_force, solved.vertical_force_a, solved.length});
    if (c.cables[i].length) expected.push_back((solved.length - c.cables[i].length->value) / kLengthDeviation);
  }
  for (std::size_t i = 0; i < c.cables.size(); ++i) {
    if (!c.cables[i].tension) continue;
    expected.push_back((c.truth.cables[i].cable.tension_a - c.cables[i].tension->value) / kTensionDeviation);
  }
  const Wrench total = totalWrench(c.robot, external, c.truth.pose, forces);
  for (int k = 0; k < c.robot.freedoms(); ++k) expected.push_back(c.load_weight(k) * total(k));
  const Evaluation own = evaluate(block, c.parameters);
  ASSERT_TRUE(own.valid);
  ASSERT_EQ(own.residuals.size(), static_cast<Eigen::Index>(expected.size()));
  for (std::size_t k = 0; k < expected.size(); ++k) {
    // The inverse solution closes to 1e-11 of tensions up to 1e5 N.
    EXPECT_NEAR(own.residuals(static_cast<Eigen::Index>(k)), expected[k], 1e-5 * (1.0 + std::abs(expected[k]))) << k;
  }
}

// At constant lengths a real platform is pulled back: the stiffness is that of the coupled Newton method, which
// solveForward() reports.
TEST_P(PlatformMeasurementsBlock, StiffnessIsThatOfForwardKinetostatics) {
  const Case c = next();
  const PlatformMeasurements block(platformOf(c.robot, Wrench::Zero()), c.cables, c.load_weight, {kTolerance});
  ASSERT_TRUE(evaluate(block, c.parameters).valid);
  RobotSolverOptions options = patient(std::get<1>(GetParam()), kTolerance);
  options.compute_stiffness = true;
  std::vector<double> lengths;
  for (const CableResult& cable : c.truth.cables) lengths.push_back(cable.cable.length);
  const RobotSolution solved = forward(c.robot, lengths, c.truth.pose, options);
  ASSERT_TRUE(solved.report.status.ok()) << solved.report.status.message;
  const int n = c.robot.freedoms();
  const Eigen::MatrixXd own = block.stiffness(block.loadBalance()).topLeftCorner(n, n);
  const Eigen::MatrixXd reported = solved.stiffness.topLeftCorner(n, n);
  EXPECT_LT((own - reported).norm(), 1e-5 * reported.norm());
}

INSTANTIATE_TEST_SUITE_P(Robots, PlatformMeasurementsBlock,
                         testing::Combine(testing::Values("cogiro", "desktop_music_wire", "paper_point_mass"),
                                          testing::Values(Model::kCatenaryInextensible, Model::kCatenary,
                                                          Model::kCatenaryCorrected, Model::kBendingInextensible,
                                                          Model::kBending)),
                         [](const testing::TestParamInfo<std::tuple<const char*, Model>>& each) {
                           return std::string(std::get<0>(each.param)) + "_" + modelName(std::get<1>(each.param));
                         });

// A failed evaluation leaves the block as it was.
TEST(PlatformMeasurements, GoesOnAfterARefusal) {
  Dice dice(62);
  const Case c = randomCase("cogiro", Model::kBending, &dice);
  const PlatformMeasurements block(platformOf(c.robot, Wrench::Zero()), c.cables, c.load_weight, {kTolerance});
  const Evaluation before = evaluate(block, c.parameters);
  ASSERT_TRUE(before.valid);
  ParameterBlocks bad = c.parameters;
  bad[2](3) = std::nan("");
  EXPECT_FALSE(evaluate(block, bad).valid);
  const Evaluation after = evaluate(block, c.parameters);
  ASSERT_TRUE(after.valid);
  EXPECT_LT((after.residuals - before.residuals).norm(), 1e-6 * (1.0 + before.residuals.norm()));
}

TEST(PlatformMeasurementsBlockInTime, ClosesNoCableAfterTheDeadline) {
  Dice dice(61);
  const Case c = randomCase("cogiro", Model::kBending, &dice);
  const auto block = [&](SolveLimits::Clock::time_point deadline) {
    return PlatformMeasurements(platformOf(c.robot, Wrench::Zero()), c.cables, c.load_weight, {kTolerance, deadline});
  };
  EXPECT_TRUE(evaluate(block(SolveLimits::Clock::time_point::max()), c.parameters).valid);
  EXPECT_FALSE(evaluate(block(SolveLimits::Clock::now() - std::chrono::seconds(1)), c.parameters).valid);
}

}  // namespace
}  // namespace cdpr_kinetostatics

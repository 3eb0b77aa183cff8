// The bending cable's closure block: analytic Jacobian against differences, and its limit EI -> 0.
#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "cdpr_kinetostatics/residuals/cable_closure.h"
#include "robot_closure_states.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kStates = 10;
constexpr double kTolerance = 1e-11;

class BendingClosureBlock : public testing::TestWithParam<ClosureKind> {};

TEST_P(BendingClosureBlock, JacobianIsThatOfCentralDifferences) {
  Dice dice(21);
  for (int i = 0; i < kStates; ++i) {
    const ClosureState s = randomClosure(GetParam(), &dice);
    const BendingClosure block(s.cable, s.anchor, s.attachment, s.chord, {kTolerance});
    const Evaluation own = evaluate(block, s.parameters);
    ASSERT_TRUE(own.valid) << "state " << i;
    ASSERT_TRUE(own.finite()) << "state " << i;
    for (std::size_t k = 0; k < 4; ++k) {
      Eigen::VectorXd steps = Eigen::VectorXd::Constant(s.parameters[k].size(), 1e-3);
      if (k == 2) steps = 1e-3 * s.parameters[k].cwiseAbs();
      if (GetParam().beside > 0.0 && k < 2) steps *= GetParam().beside;
      const Eigen::MatrixXd numeric = differences(block, s.parameters, k, steps);
      EXPECT_LT(largestDifference(own.jacobians[k], numeric, 1.0 / s.chord), 1e-6)
          << "state " << i << ", block " << k << "\n"
          << own.jacobians[k] << "\n\n"
          << numeric;
    }
  }
}

TEST_P(BendingClosureBlock, JacobianPassesTheGradientChecker) {
  Dice dice(22);
  for (int i = 0; i < kStates; ++i) {
    const ClosureState s = randomClosure(GetParam(), &dice);
    const BendingClosure block(s.cable, s.anchor, s.attachment, s.chord, {kTolerance});
    const CheckedJacobians checked = checkedJacobians(block, s.parameters);
    ASSERT_TRUE(checked.valid) << "state " << i;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(largestDifference(checked.own[k], checked.numeric[k], 1.0 / s.chord), 1e-5)
          << "state " << i << ", block " << k << "\n"
          << checked.own[k] << "\n\n"
          << checked.numeric[k];
    }
  }
}

TEST_P(BendingClosureBlock, WithoutFlexuralRigidityIsTheCatenary) {
  Dice dice(23);
  for (int i = 0; i < kStates; ++i) {
    ClosureState s = randomClosure(GetParam(), &dice);
    s.cable.bending_stiffness = 1e-6;
    const BendingClosure bending(s.cable, s.anchor, s.attachment, s.chord, {1e-10});
    const CatenaryClosure catenary(s.cable, s.anchor, s.attachment, s.chord);
    const Evaluation a = evaluate(bending, s.parameters);
    const Evaluation b = evaluate(catenary, s.parameters);
    ASSERT_TRUE(a.valid && b.valid) << "state " << i;
    EXPECT_LT((a.residuals - b.residuals).norm(), 1e-7) << "state " << i;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(largestDifference(a.jacobians[k], b.jacobians[k], 1.0 / s.chord), 1e-5) << "state " << i << ", " << k;
    }
  }
}

// The block keeps its last shape as the next start: the answer must not depend on it.
TEST_P(BendingClosureBlock, ValueDoesNotDependOnEarlierEvaluations) {
  Dice dice(24);
  const ClosureState first = randomClosure(GetParam(), &dice);
  const BendingClosure block(first.cable, first.anchor, first.attachment, first.chord, {kTolerance});
  for (int i = 0; i < kStates; ++i) {
    ParameterBlocks parameters = first.parameters;
    parameters[2] *= dice.uniform(0.7, 1.4);
    parameters[3] *= dice.uniform(0.98, 1.02);
    const BendingClosure fresh(first.cable, first.anchor, first.attachment, first.chord, {kTolerance});
    const Evaluation warm = evaluate(block, parameters);
    const Evaluation cold = evaluate(fresh, parameters);
    ASSERT_EQ(warm.valid, cold.valid) << "evaluation " << i;
    EXPECT_LT((warm.residuals - cold.residuals).norm(), 1e-9) << "evaluation " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Cables, BendingClosureBlock,
                         testing::Values(ClosureKind{"taut", -1e-3, 1e-3, 0.95, -1.0, false},
                                         ClosureKind{"slack", 0.01, 0.3, 0.7, -1.0, false},
                                         ClosureKind{"inextensible", 1e-4, 0.1, 0.9, -1.0, true},
                                         ClosureKind{"almost_vertical", -1e-3, -1e-4, 1.0, 1e-2, false}),
                         [](const testing::TestParamInfo<ClosureKind>& each) { return std::string(each.param.name); });

TEST(BendingClosure, StaysFiniteWhereTheEndLiesStraightBelowTheAnchor) {
  const BendingClosure block({1e5, 0.5, 1.0}, {1.0, 2.0, 5.0}, Eigen::Vector3d::Zero(), 4.0, {1e-10});
  const ParameterBlocks parameters = {Eigen::Vector3d(1.0, 2.0, 0.98), Eigen::Vector4d(0.0, 0.0, 0.0, 1.0),
                                      Eigen::Vector2d(125.0, 500.0), Eigen::VectorXd::Constant(1, 4.0)};
  const Evaluation e = evaluate(block, parameters);
  ASSERT_TRUE(e.valid);
  EXPECT_TRUE(e.finite());
  // A straight hanging cable does not bend: no coupling of sideways and vertical.
  EXPECT_LT(std::abs(e.jacobians[0](1, 0)), 1e-6);
  EXPECT_LT(std::abs(e.jacobians[2](1, 0)), 1e-6);
}

TEST(BendingClosure, RefusesAfterItsDeadline) {
  Dice dice(25);
  const ClosureState s = randomClosure({"slack", 0.05, 0.8, 0.9, -1.0, false}, &dice);
  SolveLimits options{kTolerance};
  const BendingClosure patient(s.cable, s.anchor, s.attachment, s.chord, options);
  EXPECT_TRUE(evaluate(patient, s.parameters).valid);
  options.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  const BendingClosure late(s.cable, s.anchor, s.attachment, s.chord, options);
  EXPECT_FALSE(evaluate(late, s.parameters).valid);
}

TEST(BendingClosure, InvalidStatesAreRefused) {
  const BendingClosure block({1e5, 0.5, 1.0}, {0.0, 0.0, 5.0}, {0.1, 0.0, 0.0}, 4.0, {1e-8});
  const ParameterBlocks good = {Eigen::Vector3d(2.0, 1.0, 2.0), Eigen::Vector4d(0.0, 0.0, 0.0, 1.0),
                                Eigen::Vector2d(30.0, 60.0), Eigen::VectorXd::Constant(1, 3.8)};
  ASSERT_TRUE(evaluate(block, good).valid);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  struct Bad {
    std::size_t block;
    Eigen::Index entry;
    double value;
  };
  for (const Bad& bad : {Bad{3, 0, 0.0}, Bad{3, 0, -1.0}, Bad{3, 0, kNan}, Bad{2, 0, kNan}, Bad{2, 0, infinity},
                         Bad{2, 1, kNan}, Bad{2, 1, infinity}, Bad{0, 0, kNan}, Bad{0, 2, kNan}}) {
    ParameterBlocks parameters = good;
    parameters[bad.block](bad.entry) = bad.value;
    EXPECT_FALSE(evaluate(block, parameters).valid)
        << "block " << bad.block << ", entry " << bad.entry << " = " << bad.value;
    EXPECT_TRUE(evaluate(block, good).valid) << "after a refusal the block must go on";
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The closure block of every sagging model: gradients, and the residual that its header states.
#include "cdpr_kinetostatics/residuals/cable_closure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "robot_closure_states.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kStates = 8;
constexpr double kTolerance = 1e-11;

class EverySaggingModel : public testing::TestWithParam<std::tuple<Model, ClosureKind>> {
 protected:
  ClosureState next() { return randomClosure(std::get<1>(GetParam()), &dice_); }
  std::unique_ptr<CableClosure> blockOf(const ClosureState& s) const {
    return makeClosure(std::get<0>(GetParam()), s.cable, s.anchor, s.attachment, 1.1 * s.chord, {kTolerance});
  }

 private:
  Dice dice_{41};
};

TEST_P(EverySaggingModel, HasTheJacobianOfCentralDifferences) {
  for (int i = 0; i < kStates; ++i) {
    const ClosureState s = next();
    const auto block = blockOf(s);
    const Evaluation own = evaluate(*block, s.parameters);
    ASSERT_TRUE(own.valid && own.finite()) << "state " << i;
    for (std::size_t k = 0; k < 4; ++k) {
      Eigen::VectorXd steps = Eigen::VectorXd::Constant(s.parameters[k].size(), 1e-3);
      if (k == 2) steps = 1e-3 * s.parameters[k].cwiseAbs();
      const Eigen::MatrixXd numeric = differences(*block, s.parameters, k, steps);
      // Integrations to 1e-11, divided by steps of 1e-3; differences of sixth order add less.
      EXPECT_LT(largestDifference(own.jacobians[k], numeric, 1.0 / s.chord), 1e-6)
          << "state " << i << ", block " << k << "\n"
          << own.jacobians[k] << "\n\n"
          << numeric;
    }
  }
}

TEST_P(EverySaggingModel, PassesTheGradientChecker) {
  for (int i = 0; i < kStates; ++i) {
    const ClosureState s = next();
    const CheckedJacobians checked = checkedJacobians(*blockOf(s), s.parameters);
    ASSERT_TRUE(checked.valid) << "state " << i;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(largestDifference(checked.own[k], checked.numeric[k], 1.0 / s.chord), 1e-5)
          << "state " << i << ", block " << k;
    }
  }
}

// Problem 1 says where the end is; the header says how that becomes the residual.
TEST_P(EverySaggingModel, ResidualIsThatOfTheHeader) {
  CableSolverOptions options;
  options.model = std::get<0>(GetParam());
  options.tolerance = kTolerance;
  for (int i = 0; i < kStates; ++i) {
    const ClosureState s = next();
    const Eigen::Quaterniond attitude(Eigen::Vector4d(s.parameters[1]));
    const Eigen::Vector3d to_b = Eigen::Vector3d(s.parameters[0]) + attitude * s.attachment - s.anchor;
    const double x = std::hypot(to_b.x(), to_b.y());
    const CableSolution cable =
        findPosition(s.cable, s.parameters[3](0), s.parameters[2](0) * x, s.parameters[2](1), options);
    ASSERT_TRUE(cable.status.ok()) << cable.status.message;
    const Eigen::Vector2d expected(cable.x / x - 1.0, (cable.y - to_b.z()) / (1.1 * s.chord));
    const Evaluation own = evaluate(*blockOf(s), s.parameters);
    ASSERT_TRUE(own.valid);
    EXPECT_LT((own.residuals - expected).norm(), 1e-9) << "state " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cables, EverySaggingModel,
    testing::Combine(testing::Values(Model::kCatenaryInextensible, Model::kCatenary, Model::kCatenaryCorrected,
                                     Model::kBendingInextensible, Model::kBending),
                     testing::Values(ClosureKind{"taut", -1e-3, 1e-3, 0.95, -1.0, false},
                                     ClosureKind{"pulley", -2e-3, 1e-3, 0.8, -1.0, false, 0.3, 4.0},
                                     ClosureKind{"slack", 0.01, 0.3, 0.7, -1.0, false})),
    [](const testing::TestParamInfo<std::tuple<Model, ClosureKind>>& each) {
      return std::string(modelName(std::get<0>(each.param))) + "_" + std::get<1>(each.param).name;
    });

}  // namespace
}  // namespace cdpr_kinetostatics

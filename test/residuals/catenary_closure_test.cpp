// The catenary's closure block: analytic Jacobian against automatic and numeric differentiation.
#include "cdpr_kinetostatics/residuals/cable_closure.h"

#include <ceres/autodiff_cost_function.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robot_closure_states.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kStates = 100;

// The closure as its header states it, with the textbook's elastic catenary.
struct Twin {
  template <typename T>
  static T arsinh(const T& x) {
    using std::log;
    using std::sqrt;
    return x < T(0.0) ? -log(sqrt(x * x + 1.0) - x) : log(x + sqrt(x * x + 1.0));
  }

  template <typename T>
  bool operator()(const T* position, const T* orientation, const T* force, const T* length, T* residuals) const {
    using std::sqrt;
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> p(position);
    const Eigen::Map<const Eigen::Quaternion<T>> q(orientation);
    const Eigen::Matrix<T, 3, 1> to_b = p + q * attachment.cast<T>() - anchor.cast<T>();
    const T x = sqrt(to_b.x() * to_b.x() + to_b.y() * to_b.y());
    const T h = force[0] * x;
    const T v = force[1];
    const T end = v - cable.weight * length[0];
    const T stretch = length[0] / cable.axial_stiffness;
    const T cable_x = h * stretch + h / cable.weight * (arsinh<T>(v / h) - arsinh<T>(end / h));
    const T cable_w = -(v - 0.5 * cable.weight * length[0]) * stretch +
                      (sqrt(h * h + end * end) - sqrt(h * h + v * v)) / cable.weight;
    residuals[0] = cable_x / x - 1.0;
    residuals[1] = (cable_w - to_b.z()) / length_scale;
    return true;
  }

  CableProperties cable;
  Eigen::Vector3d anchor, attachment;
  double length_scale;
};

class CatenaryClosureBlock : public testing::TestWithParam<ClosureKind> {};

TEST_P(CatenaryClosureBlock, JacobianIsTheAutomaticOne) {
  Dice dice(11);
  for (int i = 0; i < kStates; ++i) {
    ClosureState s = randomClosure(GetParam(), &dice);
    s.cable.bending_stiffness = 0.0;  // the textbook's catenary
    const double scale = 1.1 * s.chord;
    const CatenaryClosure block(s.cable, s.anchor, s.attachment, scale);
    const ceres::AutoDiffCostFunction<Twin, 2, 3, 4, 2, 1> twin(new Twin{s.cable, s.anchor, s.attachment, scale});
    const Evaluation own = evaluate(block, s.parameters);
    const Evaluation automatic = evaluate(twin, s.parameters);
    ASSERT_TRUE(own.valid && automatic.valid);
    // The textbook's formula loses digits as T/(q L) and chord/x grow.
    EXPECT_LT((own.residuals - automatic.residuals).norm(), 1e-9) << "state " << i;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(largestDifference(own.jacobians[k], automatic.jacobians[k], 1.0 / scale), 1e-8)
          << "state " << i << ", block " << k << "\n"
          << own.jacobians[k] << "\n\n"
          << automatic.jacobians[k];
    }
  }
}

TEST_P(CatenaryClosureBlock, JacobianPassesTheGradientChecker) {
  Dice dice(12);
  for (int i = 0; i < kStates; ++i) {
    const ClosureState s = randomClosure(GetParam(), &dice);
    const CatenaryClosure block(s.cable, s.anchor, s.attachment, 1.1 * s.chord);
    const CheckedJacobians checked = checkedJacobians(block, s.parameters);
    ASSERT_TRUE(checked.valid) << "state " << i;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(largestDifference(checked.own[k], checked.numeric[k], 1.0 / s.chord), 1e-6)
          << "state " << i << ", block " << k << "\n"
          << checked.own[k] << "\n\n"
          << checked.numeric[k];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cables, CatenaryClosureBlock,
                         testing::Values(ClosureKind{"taut", -1e-3, 1e-3, 0.95, -1.0, false},
                                         ClosureKind{"slack", 0.01, 0.8, 0.95, -1.0, false},
                                         ClosureKind{"inextensible", 1e-4, 0.3, 0.95, -1.0, true},
                                         ClosureKind{"almost_vertical", -1e-3, -1e-4, 1.0, 1e-2, false}),
                         [](const testing::TestParamInfo<ClosureKind>& each) { return std::string(each.param.name); });

TEST(CatenaryClosure, StaysFiniteAndExactWhereTheEndLiesStraightBelowTheAnchor) {
  const CableProperties cable{1e5, 0.0, 1.0};
  const CatenaryClosure block(cable, {1.0, 2.0, 5.0}, Eigen::Vector3d::Zero(), 4.0);
  // Hangs straight: T grows from V - q L to V; x/H is what closes it sideways.
  const double length = 4.0, v = 500.0;
  const double compliance = length / cable.axial_stiffness + std::log(v / (v - length)) / cable.weight;
  const double stretch = (v - 0.5 * length) * length / cable.axial_stiffness;
  const ParameterBlocks parameters = {Eigen::Vector3d(1.0, 2.0, 5.0 - length - stretch),
                                      Eigen::Vector4d(0.0, 0.0, 0.0, 1.0), Eigen::Vector2d(1.0 / compliance, v),
                                      Eigen::VectorXd::Constant(1, length)};
  const Evaluation e = evaluate(block, parameters);
  ASSERT_TRUE(e.valid);
  ASSERT_TRUE(e.finite());
  EXPECT_LT(e.residuals.norm(), 1e-12);
  // Residual 0 is even in x: no slope; residual 1 has that of the height.
  Eigen::MatrixXd by_position = Eigen::MatrixXd::Zero(2, 3);
  by_position(1, 2) = -1.0 / 4.0;
  EXPECT_LT((e.jacobians[0] - by_position).norm(), 1e-6);
  EXPECT_NEAR(e.jacobians[2](0, 0), compliance, 1e-9 * compliance);
}

TEST(CatenaryClosure, InvalidStatesAreRefused) {
  const CatenaryClosure block({1e5, 0.0, 1.0}, {0.0, 0.0, 5.0}, {0.1, 0.0, 0.0}, 4.0);
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
  for (const Bad& bad : {Bad{3, 0, 0.0}, Bad{3, 0, -1.0}, Bad{3, 0, kNan}, Bad{2, 0, 0.0}, Bad{2, 0, -5.0},
                         Bad{2, 0, kNan}, Bad{2, 1, kNan}, Bad{2, 1, infinity}, Bad{0, 0, kNan}, Bad{0, 2, kNan}}) {
    ParameterBlocks parameters = good;
    parameters[bad.block](bad.entry) = bad.value;
    EXPECT_FALSE(evaluate(block, parameters).valid)
        << "block " << bad.block << ", entry " << bad.entry << " = " << bad.value;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

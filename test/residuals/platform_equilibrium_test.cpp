// The equilibrium block: analytic Jacobian against automatic and numeric differentiation, and its sum against
// the wrench of solved robots.
#include "cdpr_kinetostatics/residuals/platform_equilibrium.h"

#include <ceres/dynamic_autodiff_cost_function.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cable/rope_on_pulley.h"
#include "robot_audit.h"
#include "robot_cases.h"
#include "robot_residuals.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kStates = 100;
constexpr double kForceScale = 300.0;
constexpr double kArmScale = 0.8;

Wrench rowWeights() {
  Wrench weights;
  weights << Eigen::Vector3d::Constant(1.0 / kForceScale), Eigen::Vector3d::Constant(1.0 / (kForceScale * kArmScale));
  return weights;
}

struct Twin {
  template <typename T>
  bool operator()(T const* const* parameters, T* residuals) const {
    using Vector = Eigen::Matrix<T, 3, 1>;
    const Eigen::Map<const Vector> p(parameters[0]);
    const Eigen::Map<const Eigen::Quaternion<T>> q(parameters[1]);
    const Vector weight(T(0.0), T(0.0), T(-platform.weight));
    Vector force = weight + platform.external_wrench.head<3>().cast<T>();
    Vector moment = (q * platform.com.cast<T>()).cross(weight) + platform.external_wrench.tail<3>().cast<T>();
    for (std::size_t i = 0; i < cables.size(); ++i) {
      const T* density = parameters[2 + i];
      const T* length = parameters[2 + cables.size() + i];
      const Vector arm = q * cables[i].attachment.cast<T>();
      const Vector to_b = p + arm - cables[i].anchor.cast<T>();
      const Vector f(-density[0] * to_b.x(), -density[0] * to_b.y(), density[1] - cables[i].weight * length[0]);
      force += f;
      moment += arm.cross(f);
    }
    for (int k = 0; k < 3; ++k) residuals[k] = force(k) / kForceScale;
    for (int k = 0; k < 3 && platform.rigid_body; ++k) residuals[3 + k] = moment(k) / (kForceScale * kArmScale);
    return true;
  }

  PlatformEquilibrium::Platform platform;
  std::vector<PlatformEquilibrium::Cable> cables;
};

struct State {
  Twin twin;
  ParameterBlocks parameters;
};

State randomState(bool rigid_body, std::size_t count, Dice* dice) {
  State s;
  s.twin.platform.rigid_body = rigid_body;
  s.twin.platform.weight = dice->uniform(100.0, 500.0);
  s.twin.platform.com = rigid_body ? Eigen::Vector3d(0.3 * dice->direction()) : Eigen::Vector3d::Zero();
  s.twin.platform.external_wrench << 50.0 * dice->direction(), 20.0 * dice->direction();
  s.parameters = {dice->inBox({-2.0, -2.0, 0.0}, {2.0, 2.0, 3.0}), dice->attitude().coeffs()};
  for (std::size_t i = 0; i < count; ++i) {
    s.twin.cables.push_back({dice->inBox({-6.0, -6.0, -1.0}, {6.0, 6.0, 6.0}),
                             rigid_body ? Eigen::Vector3d(0.6 * dice->direction()) : Eigen::Vector3d::Zero(),
                             dice->uniform(0.0, 3.0)});
    s.parameters.push_back(Eigen::Vector2d(dice->uniform(-5.0, 60.0), dice->uniform(-200.0, 400.0)));
  }
  for (std::size_t i = 0; i < count; ++i) {
    s.parameters.push_back(Eigen::VectorXd::Constant(1, dice->uniform(2.0, 9.0)));
  }
  return s;
}

class PlatformEquilibriumBlock : public testing::TestWithParam<std::tuple<bool, int>> {
 protected:
  State next() {
    return randomState(std::get<0>(GetParam()), static_cast<std::size_t>(std::get<1>(GetParam())), &dice_);
  }

 private:
  Dice dice_{31};
};

TEST_P(PlatformEquilibriumBlock, ValueAndJacobianAreTheAutomaticOnes) {
  for (int i = 0; i < kStates; ++i) {
    const State s = next();
    const PlatformEquilibrium block(s.twin.platform, s.twin.cables, rowWeights());
    ceres::DynamicAutoDiffCostFunction<Twin> twin(new Twin(s.twin));
    for (const Eigen::VectorXd& parameter : s.parameters) twin.AddParameterBlock(static_cast<int>(parameter.size()));
    twin.SetNumResiduals(s.twin.platform.rigid_body ? 6 : 3);
    ASSERT_EQ(block.num_residuals(), twin.num_residuals());
    ASSERT_EQ(block.parameter_block_sizes(), twin.parameter_block_sizes());
    const Evaluation own = evaluate(block, s.parameters);
    const Evaluation automatic = evaluate(twin, s.parameters);
    ASSERT_TRUE(own.valid && automatic.valid);
    EXPECT_LT((own.residuals - automatic.residuals).norm(), 1e-13 * (1.0 + own.residuals.norm()));
    for (std::size_t k = 0; k < s.parameters.size(); ++k) {
      EXPECT_LT(largestDifference(own.jacobians[k], automatic.jacobians[k], 1.0 / kForceScale), 1e-13)
          << "state " << i << ", block " << k;
    }
  }
}

// With guide pulleys and dead parts the weight that pulls is that of the free parts.
TEST_P(PlatformEquilibriumBlock, OnPulleysTheFreePartsWeigh) {
  for (int i = 0; i < kStates; ++i) {
    State s = next();
    std::vector<PlatformEquilibrium::Cable> bare = s.twin.cables;
    Eigen::Vector3d missing = Eigen::Vector3d::Zero();
    const std::size_t count = s.twin.cables.size();
    const Eigen::Vector3d position(s.parameters[0]);
    const Eigen::Quaterniond attitude(Eigen::Vector4d(s.parameters[1]));
    for (std::size_t k = 0; k < count; ++k) {
      PlatformEquilibrium::Cable& cable = s.twin.cables[k];
      cable.properties = {1e4, 0.0, cable.weight, {0.1, k % 2 == 0 ? RopeFrom::kBelow : RopeFrom::kAbove}, 2.0};
      s.parameters[2 + k] = Eigen::Vector2d(10.0 + std::abs(s.parameters[2 + k].x()), s.parameters[2 + k].y());
      const Eigen::Vector3d to_b = position + attitude * cable.attachment - cable.anchor;
      const ForcesAtA forces{s.parameters[2 + k].x() * to_b.head<2>().norm(), s.parameters[2 + k].y()};
      const double slope = std::atan2(-forces.vertical, forces.horizontal);
      missing.z() += cable.weight * heldRope(cable.properties, forces, slope).length;
    }
    const PlatformEquilibrium block(s.twin.platform, s.twin.cables, rowWeights());
    const Evaluation own = evaluate(block, s.parameters);
    const Evaluation without = evaluate(PlatformEquilibrium(s.twin.platform, bare, rowWeights()), s.parameters);
    ASSERT_TRUE(own.valid && without.valid);
    EXPECT_LT(((own.residuals - without.residuals).head<3>() - missing / kForceScale).norm(), 1e-12);
    const CheckedJacobians checked = checkedJacobians(block, s.parameters);
    for (std::size_t k = 0; k < s.parameters.size(); ++k) {
      EXPECT_LT(largestDifference(checked.own[k], checked.numeric[k], 1.0 / kForceScale), 1e-6)
          << "state " << i << ", block " << k;
    }
  }
}

TEST_P(PlatformEquilibriumBlock, JacobianPassesTheGradientChecker) {
  for (int i = 0; i < kStates; ++i) {
    const State s = next();
    const PlatformEquilibrium block(s.twin.platform, s.twin.cables, rowWeights());
    const CheckedJacobians checked = checkedJacobians(block, s.parameters);
    ASSERT_TRUE(checked.valid);
    for (std::size_t k = 0; k < s.parameters.size(); ++k) {
      EXPECT_LT(largestDifference(checked.own[k], checked.numeric[k], 1.0 / kForceScale), 1e-8)
          << "state " << i << ", block " << k;
    }
  }
}

// Only the Jacobians that are asked for are written.
TEST_P(PlatformEquilibriumBlock, JacobiansMayBeLeftOut) {
  const State s = next();
  const PlatformEquilibrium block(s.twin.platform, s.twin.cables, rowWeights());
  const Evaluation whole = evaluate(block, s.parameters);
  std::vector<const double*> parameters;
  for (const Eigen::VectorXd& parameter : s.parameters) parameters.push_back(parameter.data());
  Eigen::VectorXd residuals(block.num_residuals());
  ASSERT_TRUE(block.Evaluate(parameters.data(), residuals.data(), nullptr));
  EXPECT_EQ(residuals, whole.residuals);
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> one(block.num_residuals(), 2);
  std::vector<double*> outputs(parameters.size(), nullptr);
  outputs[2] = one.data();
  ASSERT_TRUE(block.Evaluate(parameters.data(), residuals.data(), outputs.data()));
  EXPECT_EQ(Eigen::MatrixXd(one), whole.jacobians[2]);
}

TEST_P(PlatformEquilibriumBlock, IsTheWrenchOfTheRobot) {
  for (int i = 0; i < kStates; ++i) {
    const State s = next();
    RobotDescription robot;
    robot.gravity = 1.0;
    robot.mass = s.twin.platform.weight;
    robot.com = s.twin.platform.com;
    Pose pose;
    pose.position = s.parameters[0];
    pose.orientation.coeffs() = s.parameters[1];
    std::vector<PlaneForces> forces;
    for (std::size_t k = 0; k < s.twin.cables.size(); ++k) {
      CableDescription cable;
      cable.anchor = s.twin.cables[k].anchor;
      cable.attachment = s.twin.cables[k].attachment;
      cable.properties.weight = s.twin.cables[k].weight;
      robot.cables.push_back(cable);
      const double x = (attachmentInWorld(pose, cable.attachment) - cable.anchor).head<2>().norm();
      forces.push_back(
          {s.parameters[2 + k](0) * x, s.parameters[2 + k](1), s.parameters[2 + s.twin.cables.size() + k](0)});
    }
    const Wrench total = totalWrench(robot, s.twin.platform.external_wrench, pose, forces);
    const PlatformEquilibrium block(s.twin.platform, s.twin.cables, Wrench::Ones());
    const Evaluation own = evaluate(block, s.parameters);
    EXPECT_LT((own.residuals - total.head(block.num_residuals())).norm(), 1e-11) << "state " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, PlatformEquilibriumBlock,
                         testing::Combine(testing::Bool(), testing::Values(1, 2, 4, 8)),
                         [](const testing::TestParamInfo<std::tuple<bool, int>>& each) {
                           return std::string(std::get<0>(each.param) ? "RigidBody" : "PointMass") +
                                  std::to_string(std::get<1>(each.param)) + "Cables";
                         });

}  // namespace
}  // namespace cdpr_kinetostatics

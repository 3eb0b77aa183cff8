// end_jacobian and force_jacobian of every rung against differences of the solver itself.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

struct Situation {
  const char* name;
  CableProperties cable;
  double length, x, y;
  double range;  // over which forces change by themselves [m]
};

const Situation kSituations[] = {
    {"TautRope", steelRope(), 5.0 / 1.0005, 3.0, 4.0, 2.5e-3},
    {"TautRopeDownwards", steelRope(), 5.0 / 1.0005, 4.5, -std::sqrt(25.0 - 4.5 * 4.5), 2.5e-3},
    {"SaggingRope", steelRope(), 8.5, 7.0, -4.0, 0.3},
    {"SlackRope", steelRope(), 6.0, 2.0, -2.0, 0.5},
    {"LevelBar", paperBar(), 4.005, 4.0, 0.0, 5e-3},
    {"ThePapersBar", paperBar(), 5.592, 5.0, -2.5, 2e-3},
    {"CompressedBar", paperBar(), 6.5, 5.0, -2.5, 0.5},
    {"MusicWire", {4.4e5, 0.0487, 0.1348}, 0.7005, 0.6, 0.36, 5e-4},
};

constexpr Model kModels[] = {Model::kStraightElastic, Model::kCatenaryInextensible, Model::kCatenary,
                             Model::kBendingInextensible, Model::kBending};

CableSolverOptions options(Model model, double tolerance = 1e-12) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = tolerance;
  return result;
}

// Derivative of f at 0 by differences of sixth order.
template <typename Function>
Eigen::Vector2d difference(const Function& f, double d) {
  return (45.0 * (f(d) - f(-d)) - 9.0 * (f(2.0 * d) - f(-2.0 * d)) + (f(3.0 * d) - f(-3.0 * d))) / (60.0 * d);
}

struct Case {
  Situation situation;
  Model model;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.situation.name << ", " << modelName(c.model); }

// Every rung where it has an answer with a tension.
std::vector<Case> cases() {
  std::vector<Case> result;
  for (const Situation& situation : kSituations) {
    const bool stretched = std::hypot(situation.x, situation.y) >= situation.length;
    for (const Model model : kModels) {
      if (stretched ? !isInextensible(model) : !isStraight(model)) result.push_back({situation, model});
    }
  }
  return result;
}

class Jacobians : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    solution_ = findForces(at_.cable, at_.length, at_.x, at_.y, options(model_));
    ASSERT_TRUE(solution_.status.ok()) << solution_.status.message;
  }

  const Situation at_ = GetParam().situation;
  const Model model_ = GetParam().model;
  CableSolution solution_;
};

TEST_P(Jacobians, OfForcesAreDifferencesOfProblem2) {
  for (int column = 0; column < 3; ++column) {
    const auto forces = [&](double change) -> Eigen::Vector2d {
      double input[] = {at_.x, at_.y, at_.length};
      input[column] += change;
      const CableSolution s = findForces(at_.cable, input[2], input[0], input[1], options(model_));
      EXPECT_TRUE(s.status.ok()) << s.status.message;
      return {s.horizontal_force, s.vertical_force_a};
    };
    const Eigen::Vector2d expected = difference(forces, 5e-3 * at_.range);
    EXPECT_LT((solution_.force_jacobian.col(column) - expected).norm(), 1e-6 * solution_.force_jacobian.norm())
        << "column " << column << ": " << solution_.force_jacobian.col(column).transpose() << " but "
        << expected.transpose();
  }
}

TEST_P(Jacobians, OfTheEndAreDifferencesOfProblem1) {
  const double h = solution_.horizontal_force;
  const double v = solution_.vertical_force_a;
  for (int column = 0; column < 3; ++column) {
    const auto end = [&](double change) -> Eigen::Vector2d {
      double input[] = {h, v, at_.length};
      input[column] += change;
      const CableSolution s = findPosition(at_.cable, input[2], input[0], input[1], options(model_));
      EXPECT_TRUE(s.status.ok()) << s.status.message;
      return {s.x, s.y};
    };
    const double d = column < 2 ? 2e-3 * std::abs(h) : 1e-3 * at_.length;
    const Eigen::Vector2d expected = difference(end, d);
    const Eigen::Vector2d computed = solution_.end_jacobian.col(column);
    EXPECT_LT((computed - expected).norm(), 2e-7 * computed.norm() + 1e-11 * at_.length / d)
        << "column " << column << ": " << computed.transpose() << " but " << expected.transpose();
  }
}

TEST_P(Jacobians, OfEndAndForcesAreInverse) {
  const Eigen::Matrix2d compliance = solution_.end_jacobian.leftCols<2>();
  const Eigen::Matrix<double, 2, 3> product = compliance * solution_.force_jacobian;
  Eigen::Matrix<double, 2, 3> expected;
  expected << Eigen::Matrix2d::Identity(), -solution_.end_jacobian.col(2);
  EXPECT_LT((product - expected).norm(), 1e-9);
}

// The end point is the gradient of a complementary energy in (H, -V), except that the paper's law of
// curvature, per strained length, has none: there the asymmetry is of the order of the end layers' strain.
TEST_P(Jacobians, ComplianceIsSymmetricWhereThereIsAnEnergy) {
  const double asymmetry = solution_.end_jacobian(0, 1) + solution_.end_jacobian(1, 0);
  const double size = solution_.end_jacobian.leftCols<2>().norm();
  double allowed = 1e-9 * size;
  if (model_ == Model::kBending) {
    const double strain = std::max(solution_.tension_a, solution_.tension_b) / at_.cable.axial_stiffness;
    allowed += strain * size;
  }
  EXPECT_LE(std::abs(asymmetry), allowed);
}

std::string nameOf(const ::testing::TestParamInfo<Case>& test) {
  return std::string(test.param.situation.name) + "_" + modelName(test.param.model);
}

INSTANTIATE_TEST_SUITE_P(EverySituation, Jacobians, ::testing::ValuesIn(cases()), nameOf);

// No difference is taken across x = 0: the limit is.
TEST(JacobiansAtAVerticalChord, AreTheLimitOfNearlyVerticalOnes) {
  for (const CableProperties& cable : {steelRope(), paperBar()}) {
    for (const double y : {5.0, -5.0}) {
      for (const double strain : {5e-4, 1e-5}) {
        const double length = 5.0 / (1.0 + strain);
        const CableSolution at = findForces(cable, length, 0.0, y, options(Model::kBending, 1e-11));
        const double x = 1e-6;
        const CableSolution near = findForces(cable, length, x, y, options(Model::kBending, 1e-11));
        ASSERT_TRUE(at.status.ok() && near.status.ok()) << at.status.message << near.status.message;
        const double difference_quotient = near.horizontal_force / x;
        EXPECT_NEAR(at.force_jacobian(0, 0), difference_quotient, 1e-7 * difference_quotient)
            << "EI " << cable.bending_stiffness << ", y " << y << ", strain " << strain;
      }
    }
  }
}

TEST(JacobianOfAnInextensibleLine, IsZeroBecauseForcesDoNotFollowFromItsGeometry) {
  const CableSolution s = findPosition(steelRope(), 5.0, 100.0, 30.0, options(Model::kStraight));
  ASSERT_TRUE(s.status.ok()) << s.status.message;
  EXPECT_EQ(s.force_jacobian.norm(), 0.0);
  EXPECT_GT(s.end_jacobian.norm(), 0.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// A shot and its sensitivities against differences of itself, and against automatic differentiation of the
// paper's equations under another integrator.
#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <ostream>
#include <string>

#include "cable/shot.h"
#include "cable_equations.h"

namespace cdpr_kinetostatics {
namespace {

struct ShotCase {
  const char* name;
  ShotParameters parameters;
  double t0, t1;
  ShotState start;
};

void PrintTo(const ShotCase& shot, std::ostream* out) { *out << shot.name; }

const ShotCase kCases[] = {
    {"taut", {0.8, 0.6, 0.002, 1e-4}, 0.0, 3.0, {-0.62, 0.01, 0.0, 0.0}},
    {"slack", {0.3, 0.5, 0.2, 1e-5}, 0.4, 3.2, {-1.0, 0.2, 1.0, -2.0}},
    {"veryElastic", {0.9, -0.4, 0.05, 0.05}, 0.0, 2.5, {0.4, -0.1, 0.0, 0.0}},
    {"inextensible", {0.9, -0.4, 0.05, 0.0}, 0.0, 2.5, {0.4, -0.1, 0.0, 0.0}},
    {"compressed", {-0.6, 0.3, 0.1, 1e-4}, 0.0, 3.0, {-0.7, 0.3, 0.0, 0.0}},
    {"weightless", {1.0, 0.0, 0.0, 1e-3}, 0.0, 3.0, {0.3, 0.2, 0.0, 0.0}},
};

Eigen::Vector4d vectorOf(const ShotState& state) { return {state.alpha, state.moment, state.x, state.y}; }

// The case with one of (alpha0, moment0, h, v) changed.
ShotCase moved(ShotCase c, int column, double change) {
  double* const variables[] = {&c.start.alpha, &c.start.moment, &c.parameters.h, &c.parameters.v};
  *variables[column] += change;
  return c;
}

class ShotSensitivity : public ::testing::TestWithParam<ShotCase> {};

TEST_P(ShotSensitivity, AreTheDerivativesOfTheShotOnItsOwnGrid) {
  const ShotCase& c = GetParam();
  StepGrid grid;
  Shot shot;
  ASSERT_TRUE(shootAdaptive(c.parameters, c.t0, c.t1, c.start, 1e-7, &grid, &shot));
  for (int column = 0; column < 4; ++column) {
    const auto end = [&](double change) -> Eigen::Vector4d {
      const ShotCase at = moved(c, column, change);
      Shot result;
      EXPECT_TRUE(shootOnGrid(at.parameters, at.t0, at.start, grid, 1.0, &result));
      return vectorOf(result.end);
    };
    const double d = 2e-3;  // differences of sixth order
    const Eigen::Vector4d difference =
        (45.0 * (end(d) - end(-d)) - 9.0 * (end(2.0 * d) - end(-2.0 * d)) + (end(3.0 * d) - end(-3.0 * d))) /
        (60.0 * d);
    EXPECT_LT((shot.sensitivity.col(column) - difference).lpNorm<Eigen::Infinity>(),
              1e-10 * (1.0 + shot.sensitivity.col(column).lpNorm<Eigen::Infinity>()))
        << "column " << column;
  }
}

TEST_P(ShotSensitivity, RepeatedStepsReportTheErrorsThatTheyWereChosenFor) {
  const ShotCase& c = GetParam();
  StepGrid grid;
  Shot chosen, repeated;
  ASSERT_TRUE(shootAdaptive(c.parameters, c.t0, c.t1, c.start, 1e-7, &grid, &chosen));
  ASSERT_TRUE(shootOnGrid(c.parameters, c.t0, c.start, grid, 1.0, &repeated));
  EXPECT_GT(chosen.step_error, 0.0);
  EXPECT_DOUBLE_EQ(repeated.step_error, chosen.step_error);
}

// In the dimensionless form EI = 1, EA = 1/eps, q = q.
TEST_P(ShotSensitivity, AgreeWithAutomaticDifferentiationOfThePapersEquations) {
  using Jet = ceres::Jet<double, 4>;
  const ShotCase& c = GetParam();
  const CableProperties cable{1.0 / c.parameters.eps, 1.0, c.parameters.q};
  const CableState<Jet> start{Jet(c.start.alpha, 0), Jet(c.start.moment, 1), Jet(c.start.x), Jet(c.start.y)};
  const CableState<Jet> end =
      integrateCable<Jet>(cable, Jet(c.parameters.h, 2), Jet(c.parameters.v, 3), Jet(c.t0), Jet(c.t1), start, 3000);
  StepGrid grid;
  Shot shot;
  ASSERT_TRUE(shootAdaptive(c.parameters, c.t0, c.t1, c.start, 1e-13, &grid, &shot));
  const Eigen::Vector4d state = vectorOf(shot.end);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(state[i], end[i].a, 1e-10) << "row " << i;
    for (int j = 0; j < 4; ++j) {
      EXPECT_NEAR(shot.sensitivity(i, j), end[i].v[j], 1e-9 * (1.0 + std::abs(end[i].v[j])))
          << "row " << i << ", column " << j;
    }
  }
}

// Liouville: (alpha, M) of an inextensible cable is a Hamiltonian system.
TEST_P(ShotSensitivity, PreserveTheAreaOfAngleAndMoment) {
  ShotCase c = GetParam();
  c.parameters.eps = 0.0;
  StepGrid grid;
  Shot shot;
  ASSERT_TRUE(shootAdaptive(c.parameters, c.t0, c.t1, c.start, 1e-13, &grid, &shot));
  EXPECT_NEAR((shot.sensitivity.topLeftCorner<2, 2>().determinant()), 1.0, 1e-9);
}

TEST_P(ShotSensitivity, AShotOnItsOwnGridIsTheSameShot) {
  const ShotCase& c = GetParam();
  StepGrid grid;
  Shot adaptive, frozen;
  ASSERT_TRUE(shootAdaptive(c.parameters, c.t0, c.t1, c.start, 1e-7, &grid, &adaptive));
  ASSERT_TRUE(shootOnGrid(c.parameters, c.t0, c.start, grid, 1.0, &frozen));
  EXPECT_EQ(vectorOf(adaptive.end), vectorOf(frozen.end));
  EXPECT_EQ(adaptive.sensitivity, frozen.sensitivity);
  double sum = c.t0;
  for (const double step : grid) sum += step;
  EXPECT_NEAR(sum, c.t1, 1e-14);
  EXPECT_EQ(frozen.work.steps, static_cast<int>(grid.size()));
  EXPECT_GE(adaptive.work.steps, frozen.work.steps);
  EXPECT_GE(frozen.work.evaluations, 6 * frozen.work.steps);
}

std::string nameOf(const ::testing::TestParamInfo<ShotCase>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(Cases, ShotSensitivity, ::testing::ValuesIn(kCases), nameOf);

// Steps are chosen by the state's error. That of a straight cable is zero, however its sensitivities turn:
// they are hyperbolic functions of the length over the bending layer's thickness.
TEST(Shot, TheSensitivitiesOfAStraightCableAreIntegratedToo) {
  ShotParameters p;
  p.h = 0.6;
  p.v = -0.8;
  StepGrid grid;
  Shot shot;
  ASSERT_TRUE(shootAdaptive(p, 0.0, 3.0, {std::atan2(0.8, 0.6), 0.0, 0.0, 0.0}, 1e-9, &grid, &shot));
  EXPECT_NEAR(shot.sensitivity(0, 0) / std::cosh(3.0), 1.0, 1e-4);
  EXPECT_NEAR(shot.sensitivity(0, 1) / std::sinh(3.0), 1.0, 1e-4);
  EXPECT_NEAR(shot.sensitivity(1, 0) / std::sinh(3.0), 1.0, 1e-4);
  // On fine steps they are exact.
  ASSERT_TRUE(shootOnGrid(p, 0.0, {std::atan2(0.8, 0.6), 0.0, 0.0, 0.0}, StepGrid(300, 0.01), 1.0, &shot));
  EXPECT_NEAR(shot.sensitivity(0, 0), std::cosh(3.0), 1e-9);
  EXPECT_NEAR(shot.sensitivity(0, 1), std::sinh(3.0), 1e-9);
}

TEST(Shot, ErrorsFallWithTheTolerance) {
  const ShotCase& c = kCases[1];
  const auto end = [&](double tolerance) {
    StepGrid grid;
    Shot shot;
    EXPECT_TRUE(shootAdaptive(c.parameters, c.t0, c.t1, c.start, tolerance, &grid, &shot));
    return vectorOf(shot.end);
  };
  const Eigen::Vector4d exact = end(1e-14);
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    EXPECT_LT((end(tolerance) - exact).norm(), 100.0 * tolerance) << tolerance;
  }
}

TEST(Shot, OneThatBlowsUpIsRejectedNotReturned) {
  ShotParameters p;
  p.h = 1.0;
  StepGrid grid;
  Shot shot;
  EXPECT_FALSE(shootAdaptive(p, 0.0, 1e6, {3.0, 2.0, 0.0, 0.0}, 1e-9, &grid, &shot));
  const double nan = std::nan("");
  EXPECT_FALSE(shootAdaptive(p, 0.0, 1.0, {nan, 0.0, 0.0, 0.0}, 1e-9, &grid, &shot));
}

}  // namespace
}  // namespace cdpr_kinetostatics

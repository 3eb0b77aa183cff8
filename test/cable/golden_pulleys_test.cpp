// The three problems of cables on guide pulleys against reference values of an independent solver
// (test/golden/README.md).
#include <gtest/gtest.h>

#include <cmath>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "golden_cables.h"

namespace cdpr_kinetostatics {
namespace {

// The reference is converged to 1e-9 or better.
constexpr double kAccuracy = 1e-7;
constexpr double kLengthAccuracy = 1e-9;

CableSolverOptions options(Model model) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = 1e-9;
  return result;
}

class GoldenPulley : public ::testing::TestWithParam<GoldenPulleyCable> {
 protected:
  void expectWholeAnswer(const CableSolution& solution) const {
    const GoldenPulleyCable& g = GetParam();
    ASSERT_TRUE(solution.status.ok()) << solution.status.message;
    EXPECT_EQ(solution.model, Model::kBending);
    EXPECT_NEAR(solution.horizontal_force, g.h, kAccuracy * g.tension_a);
    EXPECT_NEAR(solution.vertical_force_a, g.v, kAccuracy * g.tension_a);
    EXPECT_NEAR(solution.vertical_force_b, g.v - g.cable.weight * g.free_length, kAccuracy * g.tension_a);
    EXPECT_NEAR(solution.x, g.x, kLengthAccuracy * g.length);
    EXPECT_NEAR(solution.y, g.y, kLengthAccuracy * g.length);
    EXPECT_NEAR(solution.length, g.length, kLengthAccuracy * g.length);
    EXPECT_NEAR(solution.free_length, g.free_length, kLengthAccuracy * g.free_length);
    EXPECT_NEAR(solution.angle_a, g.angle_a, kAccuracy);
    EXPECT_NEAR(solution.angle_b, g.angle_b, kAccuracy);
    EXPECT_NEAR(solution.wrap_angle, g.wrap, kAccuracy);
    EXPECT_NEAR(solution.max_moment, g.max_moment, kAccuracy * g.max_moment);
    const double r = g.cable.pulley.radius;
    EXPECT_NEAR(std::hypot(solution.departure_x - r, solution.departure_y), r, 1e-12 * r);
  }
};

TEST_P(GoldenPulley, Problem1FindsThePosition) {
  const GoldenPulleyCable& g = GetParam();
  expectWholeAnswer(findPosition(g.cable, g.length, g.h, g.v, options(Model::kBending)));
}

TEST_P(GoldenPulley, Problem2FindsTheForces) {
  const GoldenPulleyCable& g = GetParam();
  expectWholeAnswer(findForces(g.cable, g.length, g.x, g.y, options(Model::kBending)));
}

TEST_P(GoldenPulley, Problem3FindsTheLengthNearestToTheHint) {
  const GoldenPulleyCable& g = GetParam();
  expectWholeAnswer(findLength(g.cable, g.x, g.y, g.tension_a, g.length, options(Model::kBending)));
}

// The same forces put the end elsewhere by what the model leaves out; it says so itself.
TEST_P(GoldenPulley, CoarserModelsKnowTheirErrors) {
  const GoldenPulleyCable& g = GetParam();
  for (const Model model : {Model::kStraightElastic, Model::kCatenary, Model::kCatenaryCorrected}) {
    const CableSolution solution = findPosition(g.cable, g.length, g.h, g.v, options(model));
    if (!solution.status.ok()) {  // a line without tension has no end
      EXPECT_EQ(model, Model::kStraightElastic) << solution.status.message;
      continue;
    }
    if (model == Model::kStraightElastic) continue;  // its estimate is that between its ends
    // A catenary whose forces would change by more than a tenth does not know them in proportion.
    EXPECT_TRUE(solution.error_known || model == Model::kCatenary);
    const double error = std::hypot(solution.x - g.x, solution.y - g.y);
    const double factor = model == Model::kCatenaryCorrected ? 5.0 : 1.2;
    EXPECT_LT(error, factor * solution.estimated_error) << modelName(model);
    EXPECT_GT(error, solution.estimated_error / factor) << modelName(model);
  }
}

// What AUTO chooses is as accurate as asked for, and not finer than needed where the pulley's effect is far smaller.
TEST_P(GoldenPulley, AutoSeesThePulley) {
  const GoldenPulleyCable& g = GetParam();
  const double effect = g.cable.bending_stiffness / (2.0 * g.cable.pulley.radius * g.tension_a);
  for (const double accuracy : {1e-3, 1e-5, 1e-7}) {
    CableSolverOptions on_ladder = options(Model::kAuto);
    on_ladder.accuracy = accuracy;
    const CableSolution solution = findPosition(g.cable, g.length, g.h, g.v, on_ladder);
    ASSERT_TRUE(solution.status.ok()) << solution.status.message;
    EXPECT_LT(std::hypot(solution.x - g.x, solution.y - g.y), accuracy + 1e-9 * g.length);
    if (effect > accuracy) {
      EXPECT_GT(static_cast<int>(solution.model), static_cast<int>(Model::kCatenary));
    }
    if (effect < 0.1 * accuracy) {
      EXPECT_NE(solution.model, Model::kBending);
    }
  }
}

TEST(GoldenPulleyFile, HoldsTheCasesItIsKnownToHold) { EXPECT_EQ(goldenPulleyCables(TEST_DATA_DIR).size(), 24u); }

INSTANTIATE_TEST_SUITE_P(AllCables, GoldenPulley, ::testing::ValuesIn(goldenPulleyCables(TEST_DATA_DIR)));

}  // namespace
}  // namespace cdpr_kinetostatics

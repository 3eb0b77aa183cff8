// The three problems against reference values of an independent solver (test/golden/README.md).
#include <gtest/gtest.h>

#include <cmath>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "golden_cables.h"

namespace cdpr_kinetostatics {
namespace {

// The reference is converged to 1e-9 or better; bending layers and folds cost up to two digits of that.
constexpr double kAccuracy = 1e-7;

CableSolverOptions options(Model model) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = 1e-9;
  return result;
}

class Golden : public ::testing::TestWithParam<GoldenCable> {
 protected:
  void expectWholeAnswer(const CableSolution& solution) const {
    const GoldenCable& g = GetParam();
    ASSERT_TRUE(solution.status.ok()) << solution.status.message;
    EXPECT_EQ(solution.model, Model::kBending);
    EXPECT_NEAR(solution.horizontal_force, g.h, kAccuracy * g.tension_a);
    EXPECT_NEAR(solution.vertical_force_a, g.v, kAccuracy * g.tension_a);
    EXPECT_NEAR(solution.tension_a, g.tension_a, kAccuracy * g.tension_a);
    EXPECT_NEAR(solution.x, g.x, kAccuracy * g.length);
    EXPECT_NEAR(solution.y, g.y, kAccuracy * g.length);
    EXPECT_NEAR(solution.length, g.length, kAccuracy * g.length);
    EXPECT_NEAR(solution.angle_a, g.angle_a, kAccuracy);
    EXPECT_NEAR(solution.angle_b, g.angle_b, kAccuracy);
    EXPECT_NEAR(solution.tension_b, std::hypot(g.h, g.v - g.cable.weight * g.length), kAccuracy * g.tension_a);
  }
};

TEST_P(Golden, Problem1FindsThePosition) {
  const GoldenCable& g = GetParam();
  expectWholeAnswer(findPosition(g.cable, g.length, g.h, g.v, options(Model::kBending)));
}

TEST_P(Golden, Problem2FindsTheForces) {
  const GoldenCable& g = GetParam();
  expectWholeAnswer(findForces(g.cable, g.length, g.x, g.y, options(Model::kBending)));
}

TEST_P(Golden, Problem3FindsTheLengthNearestToTheHint) {
  const GoldenCable& g = GetParam();
  expectWholeAnswer(findLength(g.cable, g.x, g.y, g.tension_a, g.length, options(Model::kBending)));
}

TEST_P(Golden, Problem3WithoutAHintFindsNoLongerLength) {
  const GoldenCable& g = GetParam();
  const CableSolution solution = findLength(g.cable, g.x, g.y, g.tension_a, 0.0, options(Model::kBending));
  ASSERT_TRUE(solution.status.ok()) << solution.status.message;
  EXPECT_NEAR(solution.tension_a, g.tension_a, kAccuracy * g.tension_a);
  EXPECT_LT(solution.length, g.length * (1.0 + kAccuracy));
}

TEST_P(Golden, CatenaryForces) {
  const GoldenCable& g = GetParam();
  const CableSolution solution = findForces(g.cable, g.length, g.x, g.y, options(Model::kCatenary));
  ASSERT_TRUE(solution.status.ok()) << solution.status.message;
  const double tension = std::hypot(g.catenary_h, g.catenary_v);
  EXPECT_NEAR(solution.horizontal_force, g.catenary_h, 1e-9 * tension);
  EXPECT_NEAR(solution.vertical_force_a, g.catenary_v, 1e-9 * tension);
}

TEST(GoldenFile, HoldsTheCasesItIsKnownToHold) { EXPECT_EQ(goldenCables(TEST_DATA_DIR).size(), 24u); }

INSTANTIATE_TEST_SUITE_P(AllCables, Golden, ::testing::ValuesIn(goldenCables(TEST_DATA_DIR)));

}  // namespace
}  // namespace cdpr_kinetostatics

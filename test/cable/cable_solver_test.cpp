// AUTO for one cable: which model it takes, and what it says of that.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

CableSolverOptions options(Model model, double tolerance = 1e-8) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = tolerance;
  return result;
}

TEST(Auto, TakesTheCoarsestRungThatIsAccurateEnough) {
  const auto chosen = [](double accuracy) {
    CableSolverOptions asked = options(Model::kAuto);
    asked.accuracy = accuracy;
    const CableSolution s = findForces(steelRope(), 8.03, 7.0, -4.0, asked);
    EXPECT_TRUE(s.status.ok()) << s.status.message;
    EXPECT_LE(s.estimated_error, accuracy);
    return s.model;
  };
  const CableSolution catenary = findForces(steelRope(), 8.03, 7.0, -4.0, options(Model::kCatenary));
  const CableSolution corrected = findForces(steelRope(), 8.03, 7.0, -4.0, options(Model::kCatenaryCorrected));
  EXPECT_EQ(chosen(2.1 * catenary.estimated_error), Model::kCatenary);
  EXPECT_EQ(chosen(1.9 * catenary.estimated_error), Model::kCatenaryCorrected);
  EXPECT_EQ(chosen(1.9 * corrected.estimated_error), Model::kBending);

  CableSolverOptions coarse = options(Model::kAuto);
  coarse.accuracy = 0.1;
  const CableSolution taut = findLength(steelRope(), 7.0, -4.0, 1000.0, 0.0, coarse);
  EXPECT_EQ(taut.model, Model::kStraightElastic);
  EXPECT_NE(taut.status.message.find("neglects"), std::string::npos) << taut.status.message;
}

TEST(Auto, GoesToBendingWhereNoEstimateHolds) {
  const CableProperties bar = paperBar();
  CableSolverOptions asked = options(Model::kAuto);
  asked.accuracy = 0.5;
  for (const double length : {5.592, 7.0}) {
    const CableSolution s = findForces(bar, length, 5.0, -2.5, asked);
    ASSERT_TRUE(s.status.ok()) << s.status.message;
    EXPECT_EQ(s.model, Model::kBending) << length;
  }
}

TEST(Auto, KnowsThatTheCatenaryIsExactBelowTheAnchor) {
  for (const double bending_stiffness : {0.0, steelRope().bending_stiffness}) {
    CableProperties rope = steelRope();
    rope.bending_stiffness = bending_stiffness;
    CableSolverOptions asked = options(Model::kAuto);
    asked.accuracy = 1e-9;
    const CableSolution s = findForces(rope, 4.99, 0.0, -5.0, asked);
    ASSERT_TRUE(s.status.ok()) << s.status.message;
    EXPECT_LE(s.model, Model::kCatenary) << bending_stiffness;
    const CableSolution bending = findForces(rope, 4.99, 0.0, -5.0, options(Model::kBending, 1e-11));
    EXPECT_NEAR(s.vertical_force_a, bending.vertical_force_a, 1e-9 * bending.vertical_force_a);
  }
}

TEST(Auto, RefusesAnAccuracyThatIsNone) {
  for (const double bad : {0.0, -1e-3, std::numeric_limits<double>::quiet_NaN()}) {
    CableSolverOptions asked = options(Model::kAuto);
    asked.accuracy = bad;
    const CableSolution s = findForces(steelRope(), 8.1, 7.0, -4.0, asked);
    EXPECT_EQ(s.status.code, Code::kInvalidInput);
    EXPECT_NE(s.status.message.find("accuracy"), std::string::npos) << s.status.message;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

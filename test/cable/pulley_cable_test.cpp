// Cables on guide pulleys and with dead parts, every model: round trips of the three problems, derivatives, and the
// limits in which they become something that is known otherwise.
#include "cable/pulley_cable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "cable/rope_on_pulley.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"
#include "random_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kCables = 60;
constexpr double kTolerance = 1e-11;

CableSolverOptions optionsOf(Model model, int profile_points = 0) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = kTolerance;
  result.profile_points = profile_points;
  return result;
}

// Random cables between taut and slack, each on a pulley of its own with up to as much dead rope as free one.
class CablesOnPulleys {
 public:
  CablesOnPulleys() {
    cables_.fewest_layers = 40.0;
    cables_.least_strain = 1e-5;
    cables_.most_slack = 1.2;
    cables_.steepest = 1.3;
  }

  CableCase next() {
    for (;;) {
      CableCase c = cables_.next();
      const double chord = c.chord();
      c.cable.pulley.radius = chord * uniform(0.003, 0.05);
      c.cable.pulley.rope_from = uniform(0.0, 1.0) < 0.5 ? RopeFrom::kBelow : RopeFrom::kAbove;
      c.cable.dead_length = chord * uniform(0.0, 1.0);
      if (!checkReach(c.cable.pulley, c.x, c.y).ok()) continue;
      c.length *= straightWay(c.cable, c.x, c.y) / chord;
      const std::optional<ForcesAtA> forces = hangingForces(c.cable, c.length, c.x, c.y);
      if (!forces) continue;
      const double thickness = std::sqrt(c.cable.bending_stiffness / forces->tension());
      if (thickness < 1.2 * c.cable.pulley.radius && forces->horizontal > 0.0 &&
          checkContact(c.cable, *forces, tautDeparture(c.cable, *forces)).ok()) {
        return c;
      }
    }
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }

  RandomCables cables_;
  std::mt19937 generator_{7};
};

class EveryModelOnPulleys : public ::testing::TestWithParam<Model> {};

TEST_P(EveryModelOnPulleys, AnswersItsThreeProblemsAlike) {
  CablesOnPulleys cables;
  int solved = 0;
  for (int i = 0; i < kCables; ++i) {
    CableCase c = cables.next();
    if (isInextensible(GetParam())) c.length = std::max(c.length, 1.0005 * straightWay(c.cable, c.x, c.y));
    if (isStraight(GetParam())) c.length = 0.999 * straightWay(c.cable, c.x, c.y);
    const CableSolution forces = findForces(c.cable, c.length, c.x, c.y, optionsOf(GetParam(), 5));
    if (forces.status.code == Code::kInfeasible || forces.status.message.find("lift off") != std::string::npos ||
        (GetParam() == Model::kCatenaryCorrected && forces.status.message.find("too large") != std::string::npos)) {
      continue;  // the rope lifts off under the forces of this model, or nearly so
    }
    ASSERT_TRUE(forces.status.ok()) << c << ", r " << c.cable.pulley.radius << ": " << forces.status.message;
    if (isStraight(GetParam()) && forces.horizontal_force == 0.0) continue;  // a slack line has no direction
    ++solved;
    const double h = forces.horizontal_force;
    const double v = forces.vertical_force_a;
    const double size = 1e-8 * c.length;
    const CableSolution position = findPosition(c.cable, c.length, h, v, optionsOf(GetParam()));
    ASSERT_TRUE(position.status.ok()) << c << position.status.message;
    EXPECT_NEAR(position.x, c.x, size) << c;
    EXPECT_NEAR(position.y, c.y, size) << c;
    EXPECT_NEAR(position.free_length, forces.free_length, size);
    const CableSolution length = findLength(c.cable, c.x, c.y, forces.tension_a, c.length, optionsOf(GetParam()));
    ASSERT_TRUE(length.status.ok()) << c << length.status.message;
    EXPECT_NEAR(length.length, c.length, 1e-6 * c.length) << c;

    EXPECT_NEAR(forces.vertical_force_b, v - c.cable.weight * forces.free_length, 1e-12 * forces.tension_a);
    EXPECT_NEAR(forces.profile.front().x, forces.departure_x, 1e-12 * c.length);
    EXPECT_NEAR(forces.profile.front().y, forces.departure_y, 1e-12 * c.length);
    EXPECT_NEAR(forces.profile.back().x, c.x, 1e-6 * c.length);
    EXPECT_NEAR(forces.profile.back().y, c.y, 1e-6 * c.length);
    EXPECT_NEAR(forces.profile.front().alpha, forces.angle_a, 1e-9);
    if (isBending(GetParam())) {
      EXPECT_GE(forces.max_moment, c.cable.bending_stiffness / c.cable.pulley.radius * (1.0 - 1e-12));
      EXPECT_NEAR(std::abs(forces.profile.front().moment), c.cable.bending_stiffness / c.cable.pulley.radius,
                  1e-9 * forces.max_moment);
    }
  }
  EXPECT_GT(solved, kCables / 2);
}

TEST_P(EveryModelOnPulleys, HasTheDerivativesOfDifferences) {
  CablesOnPulleys cables;
  int compared = 0;
  for (int i = 0; i < 20; ++i) {
    const CableCase c = cables.next();
    const std::optional<ForcesAtA> forces = hangingForces(c.cable, c.length, c.x, c.y);
    ASSERT_TRUE(forces);
    const CableSolution at =
        findPosition(c.cable, c.length, forces->horizontal, forces->vertical, optionsOf(GetParam()));
    if (!at.status.ok()) continue;
    const double steps[] = {1e-4 * at.tension_a, 1e-4 * at.tension_a, 1e-5 * c.length};
    for (int axis = 0; axis < 3; ++axis) {
      const auto moved = [&](double by) {
        const double d = by * steps[axis];
        const CableSolution there =
            findPosition(c.cable, c.length + (axis == 2 ? d : 0.0), forces->horizontal + (axis == 0 ? d : 0.0),
                         forces->vertical + (axis == 1 ? d : 0.0), optionsOf(GetParam()));
        EXPECT_TRUE(there.status.ok()) << there.status.message;
        return Eigen::Vector2d(there.x, there.y);
      };
      const Eigen::Vector2d difference = (moved(1.0) - moved(-1.0)) / (2.0 * steps[axis]);
      EXPECT_LT((at.end_jacobian.col(axis) - difference).norm() * steps[axis],
                2e-4 * at.end_jacobian.col(axis).norm() * steps[axis] + 1e-9 * c.length)
          << c << ", axis " << axis;
    }
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModelOnPulleys,
                         ::testing::Values(Model::kStraightElastic, Model::kCatenaryInextensible, Model::kCatenary,
                                           Model::kCatenaryCorrected, Model::kBendingInextensible, Model::kBending),
                         [](const auto& each) { return std::string(modelName(each.param)); });

// A steel rope on a pulley, taut.
CableProperties ropeOnPulley() {
  CableProperties rope = steelRope();
  rope.pulley = {0.2, RopeFrom::kBelow};
  return rope;
}

TEST(CableOnPulley, TendsToTheClosedFormWithEi) {
  CableProperties rope = ropeOnPulley();
  const ForcesAtA forces{300.0, 180.0};
  const auto difference = [&](double stiffness, Model finer, Model coarser) {
    rope.bending_stiffness = stiffness;
    const CableSolution a = findPosition(rope, 9.0, forces.horizontal, forces.vertical, optionsOf(finer));
    const CableSolution b = findPosition(rope, 9.0, forces.horizontal, forces.vertical, optionsOf(coarser));
    EXPECT_TRUE(a.status.ok() && b.status.ok()) << a.status.message << b.status.message;
    return std::hypot(a.x - b.x, a.y - b.y);
  };
  // Half an order more than EI at the largest, as the free part grows with the layer's thickness and its weight turns
  // it: between sqrt(EI) and EI.
  const double to_catenary =
      difference(0.04, Model::kBending, Model::kCatenary) / difference(0.0004, Model::kBending, Model::kCatenary);
  EXPECT_GT(to_catenary, 10.0);
  EXPECT_LT(to_catenary, 101.0);
  const double to_corrected = difference(0.4, Model::kBending, Model::kCatenaryCorrected) /
                              difference(0.04, Model::kBending, Model::kCatenaryCorrected);
  EXPECT_NEAR(std::log10(to_corrected), 2.0, 0.1);  // (47) goes with EI^2
}

// An arc and a tangent; no weight, no stretch.
TEST(CableOnPulley, WithoutWeightAndStiffnessIsGeometry) {
  const double r = 0.25;
  for (const RopeFrom from : {RopeFrom::kBelow, RopeFrom::kAbove}) {
    for (const double y : {-4.0, 0.3, 5.0}) {
      const double x = 6.0;
      // The tangent's length by Pythagoras, the arc by the angles at the axis.
      const double distance = std::hypot(x - r, y);
      const double to_b = std::atan2(y, x - r);
      const double half = std::acos(r / distance);
      const double leaves = from == RopeFrom::kBelow ? to_b + half : to_b - half;  // of P, seen from the axis
      const double around = from == RopeFrom::kBelow ? M_PI - leaves : M_PI + leaves;
      const double expected = r * around + std::sqrt(distance * distance - r * r);
      CableProperties rope{std::numeric_limits<double>::infinity(), 1e-13, 1e-9, {r, from}};
      for (const Model model : {Model::kStraight, Model::kCatenaryInextensible, Model::kBendingInextensible}) {
        const CableSolution length = findLength(rope, x, y, 100.0, 0.0, optionsOf(model));
        ASSERT_TRUE(length.status.ok()) << modelName(model) << length.status.message;
        EXPECT_NEAR(length.length, expected, 1e-10);
        EXPECT_NEAR(length.wrap_angle, around, 1e-7);
      }
    }
  }
}

TEST(CableOnPulley, OfNoRadiusIsHinged) {
  CableProperties rope = steelRope();
  for (const Model model : {Model::kStraightElastic, Model::kCatenary}) {
    const CableSolution hinged = findForces(rope, 8.2, 7.0, -4.0, optionsOf(model));
    rope.pulley.radius = 1e-6;
    const CableSolution tiny = findForces(rope, 8.2, 7.0, -4.0, optionsOf(model));
    rope.pulley.radius = 0.0;
    ASSERT_TRUE(hinged.status.ok() && tiny.status.ok());
    EXPECT_NEAR(tiny.tension_a, hinged.tension_a, 1e-3 * hinged.tension_a);
    EXPECT_EQ(hinged.free_length, hinged.length);
    EXPECT_EQ(hinged.wrap_angle, 0.0);
  }
}

// The dead part is a straight piece of rope of its own: that much unstrained rope as fills its way under T_A.
TEST(CableWithDeadLength, IsOneThatHasThatPieceBesides) {
  for (const Model model : {Model::kStraightElastic, Model::kCatenary, Model::kCatenaryCorrected, Model::kBending}) {
    for (const double length : {8.04, 8.3}) {
      if (model == Model::kStraightElastic && length > 8.1) continue;
      CableProperties rope = steelRope();
      rope.dead_length = 12.0;
      const CableSolution whole = findForces(rope, length, 7.0, -4.0, optionsOf(model));
      ASSERT_TRUE(whole.status.ok()) << modelName(model) << whole.status.message;
      const double in_dead_part = 12.0 / (1.0 + whole.tension_a / rope.axial_stiffness);
      rope.dead_length = 0.0;
      const CableSolution free = findForces(rope, length + 12.0 - in_dead_part, 7.0, -4.0, optionsOf(model));
      ASSERT_TRUE(free.status.ok()) << free.status.message;
      EXPECT_NEAR(whole.horizontal_force, free.horizontal_force, 1e-8 * free.tension_a) << modelName(model);
      EXPECT_NEAR(whole.vertical_force_a, free.vertical_force_a, 1e-8 * free.tension_a) << modelName(model);
      EXPECT_NEAR(whole.free_length, free.length, 1e-12 * free.length);
      EXPECT_NEAR(whole.strained_length, free.strained_length, 1e-9 * free.length);
      EXPECT_EQ(whole.length, length);
    }
  }
}

TEST(CableOnPulley, RefusesWhatCannotBeWithASentence) {
  CableProperties rope = ropeOnPulley();
  for (const Model model : {Model::kStraightElastic, Model::kCatenary, Model::kCatenaryCorrected, Model::kBending}) {
    const CableSolution inside = findForces(rope, 1.0, 0.3, 0.05, optionsOf(model));
    EXPECT_EQ(inside.status.code, Code::kInfeasible) << modelName(model);
    EXPECT_NE(inside.status.message.find("pulley"), std::string::npos) << inside.status.message;
    const CableSolution behind = findLength(rope, 0.25, -3.0, 100.0, 0.0, optionsOf(model));
    EXPECT_EQ(behind.status.code, Code::kInfeasible) << modelName(model);
    const CableSolution short_rope = findPosition(rope, 0.1, 100.0, 0.0, optionsOf(model));
    EXPECT_FALSE(short_rope.status.ok()) << modelName(model);
  }
  rope.pulley.radius = 0.02;  // far too small for this rope under this tension
  const CableSolution lifts = findPosition(rope, 9.0, 100.0, 40.0, optionsOf(Model::kBending));
  EXPECT_FALSE(lifts.status.ok());
  EXPECT_NE(lifts.status.message.find("lift off"), std::string::npos) << lifts.status.message;
  rope.pulley.radius = -1.0;
  EXPECT_EQ(findPosition(rope, 9.0, 100.0, 40.0, optionsOf(Model::kCatenary)).status.code, Code::kInvalidInput);
  rope.pulley.radius = 0.2;
  rope.dead_length = 1e9;
  EXPECT_EQ(findPosition(rope, 9.0, 100.0, 40.0, optionsOf(Model::kCatenary)).status.code, Code::kInvalidInput);
}

TEST(CableOnPulley, ASlackLineHangsFromItsTangentPoint) {
  const CableProperties rope = ropeOnPulley();
  const CableSolution line = findForces(rope, 12.0, 7.0, -4.0, optionsOf(Model::kStraightElastic));
  ASSERT_TRUE(line.status.ok()) << line.status.message;
  EXPECT_EQ(line.horizontal_force, 0.0);
  EXPECT_NEAR(line.angle_a, tangentLine(rope.pulley, 7.0, -4.0)->angle, 1e-12);
  EXPECT_NEAR(line.free_length, 12.0 - 0.2 * line.wrap_angle, 1e-5);  // but for the stretch by its weight
}

// So taut that the length hardly follows from the tension: the length near its hint or none, never the loop of
// thousands of metres that hangs with the same tension.
TEST(InextensibleCatenaryOnPulley, HasNoFarLengthInsteadOfANearOne) {
  const CableProperties rope{14058.0, 0.0, 0.2105, {0.0868, RopeFrom::kBelow}};
  const double near = straightWay(rope, 0.4759, 2.7204);
  for (const double hint : {0.0, near}) {
    const CableSolution found = findLength(rope, 0.4759, 2.7204, 999.6, hint, optionsOf(Model::kCatenaryInextensible));
    if (found.status.ok()) {
      EXPECT_NEAR(found.length, near, 1e-4);
    } else {
      EXPECT_EQ(found.status.code, Code::kNotConverged) << found.status.message;
    }
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

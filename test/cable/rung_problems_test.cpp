// The three problems answer one another: forces found for a place and a length lead back to that place and
// that length.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"
#include "random_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kCables = 200;

struct Held {
  CableCase given;
  CableSolution solution;
};

const std::vector<Held>& heldCables() {
  static const std::vector<Held> all = [] {
    std::vector<Held> result;
    RandomCables random;
    while (result.size() < kCables) {
      const CableCase c = random.next();
      CableSolverOptions options;
      options.tolerance = 1e-10;
      const CableSolution s = findForces(c.cable, c.length, c.x, c.y, options);
      if (s.status.ok()) result.push_back({c, s});
    }
    return result;
  }();
  return all;
}

CableSolverOptions options() {
  CableSolverOptions result;
  result.tolerance = 1e-10;
  return result;
}

// CONVERGED means: under these forces, not under forces nearby.
TEST(RoundTrip, Problem1HasTheForcesAskedFor) {
  for (const Held& held : heldCables()) {
    const CableSolution& s = held.solution;
    const CableSolution back =
        findPosition(held.given.cable, s.length, s.horizontal_force, s.vertical_force_a, options());
    if (!back.status.ok()) continue;
    EXPECT_NEAR(back.horizontal_force, s.horizontal_force, 1e-9 * s.tension_a) << held.given;
    EXPECT_NEAR(back.vertical_force_a, s.vertical_force_a, 1e-9 * s.tension_a) << held.given;
  }
}

TEST(RoundTrip, Problem1ReturnsToThePlaceOfAPulledCable) {
  for (const Held& held : heldCables()) {
    const CableSolution& s = held.solution;
    if (s.horizontal_force < 0.0) continue;
    const CableSolution back =
        findPosition(held.given.cable, s.length, s.horizontal_force, s.vertical_force_a, options());
    EXPECT_TRUE(back.status.ok()) << held.given << ": " << back.status.message;
    if (!back.status.ok()) continue;
    EXPECT_NEAR(back.x, s.x, 1e-7 * s.length) << held.given;
    EXPECT_NEAR(back.y, s.y, 1e-7 * s.length) << held.given;
  }
}

// Under dead forces a compressed cable is unstable, and its end point is looked for from several starts: a few of
// a hundred may be refused, with the reason, but none may be answered with other forces.
TEST(RoundTrip, Problem1FindsAPlaceForNearlyEveryCompressedCable) {
  int compressed = 0;
  int found = 0;
  for (const Held& held : heldCables()) {
    const CableSolution& s = held.solution;
    if (s.horizontal_force >= 0.0) continue;
    ++compressed;
    const CableSolution back =
        findPosition(held.given.cable, s.length, s.horizontal_force, s.vertical_force_a, options());
    if (!back.status.ok()) {
      EXPECT_EQ(back.status.code, Code::kNotConverged) << held.given;
      EXPECT_FALSE(back.status.message.empty()) << held.given;
      continue;
    }
    ++found;
    EXPECT_NEAR(back.horizontal_force, s.horizontal_force, 1e-9 * s.tension_a) << held.given;
    EXPECT_NEAR(back.vertical_force_a, s.vertical_force_a, 1e-9 * s.tension_a) << held.given;
    EXPECT_GE(back.x, 0.0) << held.given;
  }
  RecordProperty("compressed", compressed);
  RecordProperty("found", found);
  EXPECT_GE(found, 0.97 * compressed) << found << " of " << compressed;
}

TEST(RoundTrip, Problem3ReturnsToTheLengthThatIsHinted) {
  for (const Held& held : heldCables()) {
    const CableSolution& s = held.solution;
    const CableSolution back =
        findLength(held.given.cable, held.given.x, held.given.y, s.tension_a, s.length, options());
    EXPECT_TRUE(back.status.ok()) << held.given << ": " << back.status.message;
    if (!back.status.ok()) continue;
    EXPECT_NEAR(back.tension_a, s.tension_a, 1e-8 * s.tension_a) << held.given;
    EXPECT_NEAR(back.length, s.length, 1e-6 * s.length) << held.given;
  }
}

TEST(RoundTrip, Problem3WithoutAHintFindsThisLengthOrAShorterOne) {
  for (const Held& held : heldCables()) {
    const CableSolution& s = held.solution;
    const CableSolution back = findLength(held.given.cable, held.given.x, held.given.y, s.tension_a, 0.0, options());
    EXPECT_TRUE(back.status.ok()) << held.given << ": " << back.status.message;
    if (!back.status.ok()) continue;
    EXPECT_NEAR(back.tension_a, s.tension_a, 1e-8 * s.tension_a) << held.given;
    EXPECT_LT(back.length, s.length * (1.0 + 1e-6)) << held.given;
  }
}

// What a search did before it gave up is what a user needs to see.
TEST(ARefusedSolve, ReportsItsIterationsAndWhatWasLeft) {
  // Bending is no small effect for the hanging bar: the corrected catenary is searched for in vain.
  CableSolverOptions corrected = options();
  corrected.model = Model::kCatenaryCorrected;
  const CableSolution bar = findForces(paperBar(), 7.0, 5.0, -2.5, corrected);
  EXPECT_EQ(bar.status.code, Code::kNotConverged);
  EXPECT_GT(bar.iterations, 0);
  EXPECT_GT(bar.closure_residual, 0.0);
  EXPECT_LT(bar.closure_residual, 7.0);

  // Less tension than it takes to hold the rope: every length was looked at.
  for (const Model model : {Model::kCatenary, Model::kCatenaryCorrected, Model::kBending}) {
    CableSolverOptions asked = options();
    asked.model = model;
    const CableSolution rope = findLength(steelRope(), 7.0, -4.0, 0.5, 0.0, asked);
    EXPECT_EQ(rope.status.code, Code::kInfeasible) << modelName(model);
    EXPECT_GT(rope.iterations, 10) << modelName(model);
    EXPECT_EQ(rope.integrator_steps > 0, isBending(model)) << modelName(model);
  }
}

// An infinite axial stiffness is the inextensible model, in problem 3 as well, taut and sagging.
TEST(InfiniteAxialStiffness, HasTheLengthsOfTheInextensibleModel) {
  CableProperties rope = steelRope();
  rope.axial_stiffness = kInextensible;
  const std::pair<Model, Model> pairs[] = {{Model::kStraightElastic, Model::kStraight},
                                           {Model::kCatenary, Model::kCatenaryInextensible},
                                           {Model::kBending, Model::kBendingInextensible}};
  for (const auto& [elastic, inextensible] : pairs) {
    for (const double tension : {6.0, 100.0, 1e7}) {
      CableSolverOptions asked = options();
      asked.model = elastic;
      const CableSolution infinite = findLength(rope, 7.0, -4.0, tension, 0.0, asked);
      asked.model = inextensible;
      const CableSolution rung = findLength(rope, 7.0, -4.0, tension, 0.0, asked);
      ASSERT_TRUE(infinite.status.ok()) << modelName(elastic) << ", " << tension << ": " << infinite.status.message;
      ASSERT_TRUE(rung.status.ok()) << modelName(inextensible) << ", " << tension << ": " << rung.status.message;
      EXPECT_EQ(infinite.length, rung.length) << modelName(elastic) << ", " << tension;
      EXPECT_EQ(infinite.horizontal_force, rung.horizontal_force) << modelName(elastic) << ", " << tension;
    }
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The independent check itself: collocation against published and exact values, and against claims that are wrong.
#include "collocation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "golden_cables.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

class CollocatedGolden : public ::testing::TestWithParam<GoldenCable> {};

TEST_P(CollocatedGolden, HasTheForcesOfTheReference) {
  const GoldenCable& g = GetParam();
  // Started one percent away, from the direction of the force alone.
  const VerifiedCable found = verify({g.cable, g.length, g.x, g.y, 1.01 * g.h, 0.99 * g.v, {}}, Kept::kEndPoint);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.h, g.h, 1e-8 * g.tension_a + found.force_error);
  EXPECT_NEAR(found.v, g.v, 1e-8 * g.tension_a + found.force_error);
  EXPECT_NEAR(found.angle_a, g.angle_a, 1e-8);
  EXPECT_NEAR(found.angle_b, g.angle_b, 1e-8);
  EXPECT_LT(found.force_error, 1e-8 * g.tension_a);
  EXPECT_TRUE(found.sags());
}

TEST_P(CollocatedGolden, EndsWhereTheReferenceEnds) {
  const GoldenCable& g = GetParam();
  const VerifiedCable found = verify({g.cable, g.length, g.x, g.y, g.h, g.v, {}}, Kept::kForces);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.x, g.x, 1e-8 * g.length);
  EXPECT_NEAR(found.y, g.y, 1e-8 * g.length);
}

INSTANTIATE_TEST_SUITE_P(AllCables, CollocatedGolden, ::testing::ValuesIn(goldenCables(TEST_DATA_DIR)));

// Half a wave of the weightless elastica, Euler's strut beyond its load: with the modulus k the slope at its ends is
// 2 asin(k), L sqrt(P/EI) = 2 K(k) and chord/L = 2 E(k)/K(k) - 1.
TEST(Collocation, BowOfEulersElastica) {
  for (const double slope : {0.1, 0.6, 1.2, 1.8}) {
    const double modulus = std::sin(0.5 * slope);
    const double length = 3.0;
    const double stiffness = 7.0;
    const double push = stiffness * std::pow(2.0 * std::comp_ellint_1(modulus) / length, 2);
    const double chord = length * (2.0 * std::comp_ellint_2(modulus) / std::comp_ellint_1(modulus) - 1.0);
    ClaimedCable claim{{kInextensible, stiffness, 0.0}, length, chord, 0.0, -1.02 * push, 0.0, {}};
    for (int i = 0; i <= 20; ++i) {
      const double share = i / 20.0;
      claim.profile.push_back({share * length, 0.0, 0.0, -slope * std::cos(kPi * share),
                               stiffness * slope * kPi / length * std::sin(kPi * share), 0.0, 0.0});
    }
    const VerifiedCable found = verify(claim, Kept::kEndPoint);
    ASSERT_TRUE(found.converged) << slope;
    EXPECT_NEAR(found.h, -push, 1e-10 * push) << slope;
    EXPECT_NEAR(found.v, 0.0, 1e-10 * push) << slope;
    EXPECT_NEAR(found.angle_a, -slope, 1e-10);
    EXPECT_NEAR(found.angle_b, slope, 1e-10);
    EXPECT_TRUE(found.sags()) << slope;
  }
}

TEST(Collocation, WeightlessTautCableIsALine) {
  for (const double x : {0.0, 3.0}) {
    const double length = 5.0 / 1.0005;
    const double tension = steelRope().axial_stiffness * 5e-4;
    CableProperties cable = steelRope();
    cable.weight = 0.0;
    const double y = std::sqrt(25.0 - x * x);
    const VerifiedCable found =
        verify({cable, length, x, y, 0.9 * tension * x / 5.0, -0.9 * tension * y / 5.0, {}}, Kept::kEndPoint);
    ASSERT_TRUE(found.converged);
    EXPECT_NEAR(found.h, tension * x / 5.0, 1e-9 * tension);
    EXPECT_NEAR(found.v, -tension * y / 5.0, 1e-9 * tension);
    EXPECT_TRUE(found.sags());
  }
}

// The arch of docs/theory.md section 3 solves the equations and is refused as unstable.
TEST(Collocation, TheArchThatSingleShootingFindsDoesNotSag) {
  CableSolution sagging;
  CableSolverOptions options;
  options.profile_points = 101;
  sagging = findForces(paperBar(), 5.592, 5.0, -2.5, options);
  ASSERT_TRUE(sagging.status.ok());
  ClaimedCable claim{paperBar(), 5.592, 5.0, -2.5, -1701.42, -781.82, sagging.profile};
  const double chord = std::atan2(-2.5, 5.0);
  for (ProfilePoint& p : claim.profile) {
    p.alpha = chord + 0.035 * std::cos(kPi * p.s / 5.592);
    p.moment = -paperBar().bending_stiffness * 0.035 * kPi / 5.592 * std::sin(kPi * p.s / 5.592);
  }
  const VerifiedCable found = verify(claim, Kept::kEndPoint);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.h, -1701.42, 0.01);
  EXPECT_NEAR(found.v, -781.82, 0.01);
  EXPECT_FALSE(found.stable);
  EXPECT_LT(found.area_below_chord, 0.0);
  EXPECT_FALSE(found.sags());
}

TEST(Collocation, ItsOwnErrorIsEstimated) {
  const VerifiedCable found = verify({paperBar(), 5.592, 5.0, -2.5, 834.0, 487.0, {}}, Kept::kEndPoint);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.h, 834.339978210, found.force_error + 1e-8);
  EXPECT_NEAR(found.v, 487.060469814, found.force_error + 1e-8);
  EXPECT_LT(found.force_error, 1e-6);
  EXPECT_TRUE(found.sags());
}

}  // namespace
}  // namespace cdpr_kinetostatics

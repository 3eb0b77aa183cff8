// Large deflections known in closed form or to many digits, through the bending cable's own integrator.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "cable/shot.h"
#include "cantilever.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kFine = 1e-13;  // errors of angle [rad] and moment that a step may make
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bisshopp and Drucker (1945): transverse dead force P at the tip, P L^2/EI = a^2, tip angle phi.
TEST(Elastica, CantileverOfBisshoppAndDrucker) {
  for (const double phi : {0.1, 0.5, 1.0, 1.3, 1.5}) {
    const double modulus = std::sqrt(0.5 * (1.0 + std::sin(phi)));
    const double amplitude = std::asin(1.0 / (modulus * std::sqrt(2.0)));
    const double a = std::comp_ellint_1(modulus) - std::ellint_1(modulus, amplitude);
    const double drop = 1.0 - 2.0 / a * (std::comp_ellint_2(modulus) - std::ellint_2(modulus, amplitude));
    const double reach = std::sqrt(2.0 * std::sin(phi)) / a;

    const double length = 3.0;
    const double stiffness = 7.0;
    Cantilever beam{{kInfinity, stiffness, 0.0}, length, 0.0, -a * a * stiffness / (length * length)};
    const CantileverTip tip = solveCantilever(beam, kFine);
    ASSERT_TRUE(tip.solved) << phi;
    EXPECT_NEAR(tip.alpha, -phi, 1e-11);
    EXPECT_NEAR(tip.x / length, reach, 1e-11);
    EXPECT_NEAR(tip.y / length, -drop, 1e-11);
    EXPECT_NEAR(tip.clamp_moment, beam.tip_w * tip.x, 1e-10 * stiffness);  // statics, whatever the shape
  }
}

TEST(Elastica, HeavyCantilever) {
  const CantileverTip tip = solveCantilever({{kInfinity, 1.0, 10.0}, 1.0, 0.0, 0.0}, kFine);
  ASSERT_TRUE(tip.solved);
  EXPECT_NEAR(tip.alpha, -1.0526431172, 1e-10);
  EXPECT_NEAR(tip.x, 0.656353761239, 1e-11);
  EXPECT_NEAR(tip.y, -0.700199715514, 1e-11);
}

TEST(Elastica, CurvatureIsPerStrainedLength) {
  // Per unstrained length the tip would move by (-0.508537304326, -1.207239854550).
  const CantileverTip tip = solveCantilever({{2.07e9, 1.725e6, 0.0}, 2.0, 0.0, -1.29375e6}, kFine);
  ASSERT_TRUE(tip.solved);
  EXPECT_NEAR(tip.x - 2.0, -0.508657761956, 2e-11);
  EXPECT_NEAR(tip.y, -1.207340159514, 2e-11);
}

TEST(Elastica, AnEndMomentBendsAStraightBeamIntoACircle) {
  for (const double turns : {0.25, 0.5, 1.0, 2.0}) {
    const double angle = 2.0 * kPi * turns;
    StepGrid grid;
    Shot shot;
    ASSERT_TRUE(shootAdaptive({}, 0.0, 1.0, {0.0, angle, 0.0, 0.0}, kFine, &grid, &shot));
    EXPECT_NEAR(shot.end.alpha, angle, 1e-12);
    EXPECT_NEAR(shot.end.moment, angle, 1e-15 * angle);
    // The step control looks at the angle and the moment, which are polynomials here: the arc is walked on a
    // fixed grid.
    ASSERT_TRUE(shootOnGrid({}, 0.0, {0.0, angle, 0.0, 0.0}, StepGrid(1000, 1e-3), 1.0, &shot));
    EXPECT_NEAR(shot.end.x, std::sin(angle) / angle, 1e-12);
    EXPECT_NEAR(shot.end.y, (1.0 - std::cos(angle)) / angle, 1e-12);
  }
}

// A strut, straight and weightless: a turn of its end A by 1 rad brings a moment of -k sin(k) at B, k^2 = -H L^2/EI,
// which vanishes at Euler's force.
TEST(Elastica, AStrutBucklesAtEulersForce) {
  Shot shot;
  for (const double share : {0.25, 0.999999, 1.0, 1.000001, 2.0}) {
    ShotParameters p;
    p.h = -kPi * kPi * share;
    ASSERT_TRUE(shootOnGrid(p, 0.0, {0.0, 0.0, 0.0, 0.0}, StepGrid(1000, 1e-3), 1.0, &shot));
    const double k = kPi * std::sqrt(share);
    EXPECT_NEAR(shot.sensitivity(1, 0), -k * std::sin(k), 1e-12) << share;
    EXPECT_NEAR(shot.sensitivity(0, 1), std::sin(k) / k, 1e-12) << share;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

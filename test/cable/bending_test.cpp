// Which equilibrium is the answer: the stable one that hangs below its chord, through compression, vertical
// chords and slack loops (docs/theory.md sections 1, 3 and 5).
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

CableSolverOptions options(double tolerance = 1e-9, int profile_points = 0) {
  CableSolverOptions result;
  result.tolerance = tolerance;
  result.profile_points = profile_points;
  return result;
}

// Signed area between chord and cable, positive below.
double areaBelow(const CableSolution& solution) {
  double area = 0.0;
  for (std::size_t i = 1; i < solution.profile.size(); ++i) {
    const ProfilePoint& a = solution.profile[i - 1];
    const ProfilePoint& b = solution.profile[i];
    area += 0.5 * (a.x * b.y - b.x * a.y);
  }
  return area;
}

TEST(Branch, TheBarThatSingleShootingGetsWrong) {
  const CableSolution cold = findForces(paperBar(), 5.592, 5.0, -2.5, options(1e-11));
  ASSERT_TRUE(cold.status.ok()) << cold.status.message;
  EXPECT_NEAR(cold.horizontal_force, 834.339978210, 2e-8);
  EXPECT_NEAR(cold.vertical_force_a, 487.060469814, 2e-8);
}

TEST(Branch, ABarLongerThanItsChordIsCompressedAndStillHangsBelow) {
  const double chord = std::hypot(5.0, 2.5);
  for (const double ratio : {1.004, 1.01, 1.05, 1.1, 1.3, 2.0, 3.0}) {
    const CableSolution s = findForces(paperBar(), ratio * chord, 5.0, -2.5, options(1e-9, 400));
    ASSERT_TRUE(s.status.ok()) << "L/chord " << ratio << ": " << s.status.message;
    EXPECT_LT(s.horizontal_force, 0.0) << "L/chord " << ratio;
    EXPECT_GT(areaBelow(s), 0.0) << "L/chord " << ratio;
    // No loop: the tangent turns by less than a teardrop's.
    EXPECT_LT(std::abs(s.angle_b - s.angle_a), 1.65 * kPi) << "L/chord " << ratio;
  }
  const CableSolution taut = findForces(paperBar(), 1.003 * chord, 5.0, -2.5, options());
  ASSERT_TRUE(taut.status.ok());
  EXPECT_GT(taut.horizontal_force, 0.0);
}

// Nearly straight and far beyond its buckling load it is in equilibrium too, but unstable.
TEST(Branch, ABarSlightlyTooLongBowsInsteadOfStayingStraight) {
  const CableProperties bar{342848.44169105991, 0.63731062198160482, 4.3197476063184581};
  const double length = 0.38220647631458837;
  for (const double y : {-0.22172926395243819, 0.22172926395243819}) {
    for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
      const CableSolution s = findForces(bar, length, 0.3108221329482953, y, options(tolerance));
      ASSERT_TRUE(s.status.ok()) << s.status.message;
      EXPECT_NEAR(s.horizontal_force, -27.9105, 1e-3) << "y " << y << ", tolerance " << tolerance;
      EXPECT_LT(s.tension_a, 1.1 * kPi * kPi * bar.bending_stiffness / (length * length));
    }
  }
}

// 8 um too long and far from buckling: it is compressed by EA (1 - chord/L) = 58 N, its weight is 1 N.
TEST(Branch, AShortThickRodIsCompressedNotFolded) {
  const CableProperties rod{2415854.7434455073, 87.456070012484943, 2.9785137279378571};
  const double length = 0.33084822854483237;
  const double x = 0.1717377097001955;
  for (const double y : {-0.28277460378965674, 0.28277460378965674}) {
    const CableSolution s = findForces(rod, length, x, y, options(1e-8));
    ASSERT_TRUE(s.status.ok()) << s.status.message;
    const double compression = rod.axial_stiffness * (1.0 - std::hypot(x, y) / length);
    EXPECT_NEAR(s.horizontal_force, -compression * x / length, 1.0) << "y " << y;
    EXPECT_LT(s.tension_a, 1.1 * compression) << "y " << y;
  }
}

TEST(Branch, ForcesAreContinuousInTheLengthThroughZeroTension) {
  const double chord = std::hypot(5.0, 2.5);
  CableSolution last = findForces(paperBar(), 0.99999 * chord, 5.0, -2.5, options());
  ASSERT_TRUE(last.status.ok());
  const double step = 2e-5 * chord;
  for (double length = last.length + step; length < 1.02 * chord; length += step) {
    const CableSolution s = findForces(paperBar(), length, 5.0, -2.5, options());
    ASSERT_TRUE(s.status.ok()) << "L " << length << ": " << s.status.message;
    const Eigen::Vector2d mean = 0.5 * step * (last.force_jacobian.col(2) + s.force_jacobian.col(2));
    EXPECT_NEAR(s.horizontal_force - last.horizontal_force, mean.x(), 0.1 * std::abs(mean.x()) + 1e-3) << length;
    last = s;
  }
}

TEST(Branch, ASlackRopePushesAsItsEndsCloseUp) {
  const CableProperties rope{2.87e5, 0.44, 0.064 * 9.81};
  const auto force = [&](double x) {
    const CableSolution s = findForces(rope, 6.0, x, -2.0, options());
    EXPECT_TRUE(s.status.ok()) << "x " << x << ": " << s.status.message;
    return s.horizontal_force;
  };
  EXPECT_NEAR(force(2.0), -0.081, 5e-4);
  EXPECT_NEAR(force(1.0), -0.352, 5e-4);
  EXPECT_NEAR(force(1e-6), -0.6237, 5e-5);
  EXPECT_NEAR(force(0.0), force(1e-7), 1e-6);
  // Towards x = 0 it pushes ever harder.
  double last = force(2.0);
  for (const double x : {1.5, 1.0, 0.5, 0.2, 0.1, 0.01, 1e-3, 1e-4}) {
    const double now = force(x);
    EXPECT_LT(now, last) << "x " << x;
    last = now;
  }
}

// Hooke's law of a rod whose weight is carried in halves: |y| = L (1 + N/EA).
void expectStraightVertical(const CableProperties& cable, double strain, double y) {
  const double length = std::abs(y) / (1.0 + strain);
  const CableSolution s = findForces(cable, length, 0.0, y, options(1e-10, 21));
  ASSERT_TRUE(s.status.ok()) << "strain " << strain << ", y " << y << ": " << s.status.message;
  const double v = 0.5 * cable.weight * length - std::copysign(1.0, y) * cable.axial_stiffness * strain;
  EXPECT_NEAR(s.horizontal_force, 0.0, 1e-9 * s.tension_a) << "strain " << strain << ", y " << y;
  EXPECT_NEAR(s.vertical_force_a, v, 1e-9 * s.tension_a) << "strain " << strain << ", y " << y;
  EXPECT_NEAR(s.angle_a, std::copysign(kPi / 2, y), 1e-9);
  EXPECT_NEAR(s.sag, 0.0, 1e-9 * length);
}

TEST(Branch, VerticalTautCablesAreStraight) {
  for (const double y : {-5.0, 5.0}) {
    expectStraightVertical(steelRope(), 5e-4, y);
    expectStraightVertical(paperBar(), 5e-4, y);
  }
}

// Euler's load of this bar is 3294 N, its compression 1068 N.
TEST(Branch, AVerticalStrutBelowItsBucklingLoadStaysStraight) {
  for (const double y : {-2.0, 2.0}) expectStraightVertical(paperBar(), -2e-5, y);
}

TEST(Branch, TautCablesHaveAHorizontalComplianceThatReachesItsVerticalLimit) {
  for (const double y : {-5.0, 5.0}) {
    const double length = 5.0 / 1.0005;
    const CableSolution vertical = findForces(steelRope(), length, 0.0, y, options(1e-11));
    ASSERT_TRUE(vertical.status.ok()) << vertical.status.message;
    for (const double x : {1e-1, 1e-2, 1e-3, 1e-5}) {
      const CableSolution s = findForces(steelRope(), length, x, y, options(1e-11));
      ASSERT_TRUE(s.status.ok()) << "x " << x << ": " << s.status.message;
      // The chord's growth adds x^2/(2 y^2) to a strain of 5e-4.
      const double grown = 1.0 + x * x / (2.0 * y * y) / 5e-4;
      EXPECT_NEAR(s.horizontal_force / x / vertical.force_jacobian(0, 0), grown, 1e-6 + 0.1 * x * x) << x;
    }
  }
}

TEST(Branch, SlackVerticalLoopsAreTheLimitOfNarrowOnes) {
  for (const CableProperties& cable : {paperBar(), steelRope()}) {
    for (const double y : {-2.0, -0.5, 0.5, 2.0}) {
      const CableSolution at = findForces(cable, 6.0, 0.0, y, options());
      const CableSolution near = findForces(cable, 6.0, 1e-7, y, options());
      ASSERT_TRUE(at.status.ok()) << "y " << y << ": " << at.status.message;
      ASSERT_TRUE(near.status.ok()) << "y " << y << ": " << near.status.message;
      EXPECT_LT(at.horizontal_force, 0.0);
      EXPECT_NEAR(at.horizontal_force, near.horizontal_force, 1e-5 * at.tension_a) << "y " << y;
      EXPECT_NEAR(at.vertical_force_a, near.vertical_force_a, 1e-5 * at.tension_a) << "y " << y;
      // Of the two mirror images, the one below the chords of small x > 0.
      EXPECT_GT(areaBelow(findForces(cable, 6.0, 0.0, y, options(1e-9, 101))), 0.0) << "y " << y;
    }
  }
}

// Problem 1 by any road must end with the very forces asked for.
TEST(Branch, Problem1ReturnsTheForcesAskedForInCompression) {
  const double chord = std::hypot(5.0, 2.5);
  for (const double ratio : {1.01, 1.1, 1.3, 2.0}) {
    const CableSolution held = findForces(paperBar(), ratio * chord, 5.0, -2.5, options());
    ASSERT_TRUE(held.status.ok());
    const CableSolution s =
        findPosition(paperBar(), ratio * chord, held.horizontal_force, held.vertical_force_a, options());
    ASSERT_TRUE(s.status.ok()) << "L/chord " << ratio << ": " << s.status.message;
    EXPECT_NEAR(s.horizontal_force, held.horizontal_force, 1e-9 * held.tension_a) << "L/chord " << ratio;
    EXPECT_NEAR(s.vertical_force_a, held.vertical_force_a, 1e-9 * held.tension_a) << "L/chord " << ratio;
    EXPECT_NEAR(s.x, 5.0, 1e-6 * s.length) << "L/chord " << ratio;
    EXPECT_NEAR(s.y, -2.5, 1e-6 * s.length) << "L/chord " << ratio;
  }
}

// Neighbours of cables without any stiffness against a turn: they are solved like these.
TEST(Bending, UnloadedCablesAreSolvedLikeTheirNeighbours) {
  const CableProperties weightless{2e5, 0.3, 0.0};
  for (const double length : {54.0, 54.0 * (1.0 - 1e-12), 54.0 * (1.0 + 1e-12)}) {
    const CableSolution s = findForces(weightless, length, 54.0, 0.0, {});
    ASSERT_TRUE(s.status.ok()) << length - 54.0 << s.status.message;
    EXPECT_NEAR(s.horizontal_force, 2e5 * (54.0 / length - 1.0), 1e-9);
    EXPECT_LT(s.sag, 1e-9);
  }
}

// The teardrop: a weightless elastica whose ends touch turns by 261.4 degrees.
TEST(Bending, WeightlessLoopsWithEndsThatCoincide) {
  for (const double x : {0.0, 1e-10, 1e-9, 1e-7}) {
    const CableSolution s = findForces({2e5, 0.3, 0.0}, 5.0, x, 0.0, {});
    ASSERT_TRUE(s.status.ok()) << x << s.status.message;
    EXPECT_NEAR((s.angle_b - s.angle_a) * 180.0 / M_PI, 261.4, 0.1) << x;
    EXPECT_NEAR(s.horizontal_force, -0.258589, 1e-6) << x;
    EXPECT_NEAR(s.sag, 1.95797, 1e-4) << x;
  }
}

// 3 mm of rope with both ends in one place asked for 20 GB once.
TEST(Bending, AThickLoopWithEndsThatCoincideIsAnsweredOrRefused) {
  const CableSolution s = findForces(steelRope(), 0.003, 0.0, 0.0, {});
  EXPECT_TRUE(s.status.ok() || s.status.code == Code::kNotConverged) << s.status.message;
  EXPECT_FALSE(!s.status.ok() && s.status.message.empty());
}

}  // namespace
}  // namespace cdpr_kinetostatics

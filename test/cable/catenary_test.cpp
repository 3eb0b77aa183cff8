// Catenaries and tie-beams against their closed forms, and published catenaries.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <ostream>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

CableSolverOptions options(Model model, double tolerance = 1e-9, int profile_points = 0) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = tolerance;
  result.profile_points = profile_points;
  return result;
}

using Wide = long double;

struct Point {
  Wide x, y;
};

// The paper's equation (6) in extended precision; its logarithm of (T + V) is H times a difference of asinh.
Point equation6(const CableProperties& cable, Wide h, Wide v, Wide s) {
  const Wide ea = cable.axial_stiffness;
  const Wide q = cable.weight;
  return {h * s / ea + h / q * (std::asinh(v / h) - std::asinh((v - q * s) / h)),
          s / ea * (q * s / 2 - v) + (std::hypot(h, v - q * s) - std::hypot(h, v)) / q};
}

// From a deep loop to a taut string, upward and downward.
class Forces : public ::testing::TestWithParam<std::pair<double, double>> {};  // (H, V) over the weight

TEST_P(Forces, CatenaryIsEquation6) {
  const CableProperties rope = steelRope();
  const double length = 12.0;
  const double weight = rope.weight * length;
  const double h = GetParam().first * weight;
  const double v = GetParam().second * weight;
  const CableSolution s = findPosition(rope, length, h, v, options(Model::kCatenary, 1e-9, 13));
  ASSERT_TRUE(s.status.ok()) << s.status.message;
  ASSERT_EQ(s.profile.size(), 13u);
  for (const ProfilePoint& point : s.profile) {
    const Point exact = equation6(rope, h, v, point.s);
    EXPECT_NEAR(point.x, static_cast<double>(exact.x), 1e-12 * length);
    EXPECT_NEAR(point.y, static_cast<double>(exact.y), 1e-12 * length);
  }
  EXPECT_NEAR(s.x, s.profile.back().x, 1e-15 * length);

  // And back: its forces from its end.
  const CableSolution back = findForces(rope, length, s.x, s.y, options(Model::kCatenary));
  ASSERT_TRUE(back.status.ok()) << back.status.message;
  const Point closed = equation6(rope, back.horizontal_force, back.vertical_force_a, length);
  EXPECT_NEAR(static_cast<double>(closed.x), s.x, 1e-12 * length);
  EXPECT_NEAR(static_cast<double>(closed.y), s.y, 1e-12 * length);
}

INSTANTIATE_TEST_SUITE_P(FromLoopToString, Forces,
                         ::testing::Values(std::pair(1e-3, 0.5), std::pair(0.01, 0.2), std::pair(0.1, 0.9),
                                           std::pair(0.5, 0.5), std::pair(1.0, -2.0), std::pair(0.01, 3.0),
                                           std::pair(0.02, -5.0), std::pair(5.0, 4.0), std::pair(50.0, -30.0),
                                           std::pair(300.0, 0.5), std::pair(3000.0, 1000.0)));

struct Published {
  double x, y, length, ea, q, h, digits;
};

TEST(PublishedCatenaries, OfMoorPy) {
  for (const Published& p :
       {Published{400, 200, 500, 7.51e12, 200, 43694.604622, 1e-11},
        Published{89.9, 59.2, 130, 7.51e8, 881.05, 31373.234876, 1e-11},
        Published{246.22420940032947, 263.55766330843164, 360.63566262396927, 7e8, 3.08735, 58377.241423, 1e-9}}) {
    const CableProperties cable{p.ea, 0.0, p.q};
    for (const double y : {p.y, -p.y}) {
      const CableSolution s = findForces(cable, p.length, p.x, y, options(Model::kCatenary));
      ASSERT_TRUE(s.status.ok()) << s.status.message;
      EXPECT_NEAR(s.horizontal_force, p.h, 1e-6);
      EXPECT_NEAR(s.x, p.x, 1e-12 * p.length);
      EXPECT_NEAR(s.y, y, 1e-12 * p.length);
    }
  }
}

TEST(Straight, ElasticIsHookesLaw) {
  const CableProperties rope = steelRope();
  const CableSolution s = findForces(rope, 5.0, 3.0, -4.004, options(Model::kStraightElastic));
  ASSERT_TRUE(s.status.ok()) << s.status.message;
  const double chord = std::hypot(3.0, 4.004);
  const double tension = rope.axial_stiffness * (chord / 5.0 - 1.0);
  EXPECT_NEAR(s.horizontal_force, tension * 3.0 / chord, 1e-9 * tension);
  EXPECT_NEAR(s.vertical_force_a, tension * 4.004 / chord + 0.5 * rope.weight * 5.0, 1e-9 * tension);
}

// y = -[q x(l - x)/(2 T) + q/(T k^2) (cosh(k(l/2 - x))/cosh(k l/2) - 1)], k = sqrt(T/EI).
class TieBeam : public ::testing::TestWithParam<double> {};  // kappa L

TEST_P(TieBeam, WithSmallSlopes) {
  const double length = 10.0;
  const double tension = 1000.0;
  const double slope = 1e-5;
  const double k = GetParam() / length;
  const CableProperties cable{1.0, tension / (k * k), 2.0 * slope * tension / length};
  const CableSolution s = findPosition(cable, length, tension, 0.5 * cable.weight * length,
                                       options(Model::kBendingInextensible, 1e-12, 41));
  ASSERT_TRUE(s.status.ok()) << s.status.message;
  const double q = cable.weight;
  const double sag = q * length * length / (8.0 * tension);
  EXPECT_NEAR(s.y, 0.0, 1e-9 * sag);
  for (const ProfilePoint& point : s.profile) {
    const double layer = (std::exp(-k * point.x) + std::exp(-k * (length - point.x))) / (1.0 + std::exp(-k * length));
    const double y = -(q * point.x * (length - point.x) / (2.0 * tension) + q / (tension * k * k) * (layer - 1.0));
    EXPECT_NEAR(point.y, y, 1e-8 * sag) << "x " << point.x;
    EXPECT_NEAR(point.moment, q / (k * k) * (1.0 - layer), 1e-8 * q * length / k) << "x " << point.x;
  }
  const double layer_middle = 1.0 / std::cosh(0.5 * k * length);
  EXPECT_NEAR(s.max_moment, q / (k * k) * (1.0 - layer_middle), 1e-7 * q / (k * k));
}

INSTANTIATE_TEST_SUITE_P(FromABeamToAString, TieBeam, ::testing::Values(0.5, 2.0, 7.0, 30.0, 200.0));

}  // namespace
}  // namespace cdpr_kinetostatics

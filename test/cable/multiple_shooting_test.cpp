// The chain of shots: its quiet middle in closed form against shooting the whole cable, and what it keeps and refuses.
#include "cable/multiple_shooting.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cable/catenary.h"
#include "cable/mesh_rules.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "finite_solution.h"
#include "known_cables.h"
#include "random_cables.h"

namespace cdpr_kinetostatics {
namespace {

// Problem 1 by Newton's method on the nodes alone.
bool relax(MultipleShooting* shooting) {
  for (int i = 0; i < 12; ++i) {
    if (!shooting->linearise(i < 4)) return false;
    const double size = shooting->angleChange(Eigen::Vector3d::Zero());
    shooting->step(Eigen::Vector3d::Zero(), 1.0);
    if (i > 4 && size < 1e-14) break;
  }
  return shooting->linearise(false);
}

MultipleShooting relaxed(const CableProperties& cable, double length, const ForcesAtA& forces, double tolerance,
                         Middle middle) {
  MultipleShooting shooting;
  shooting.start(cable, length, forces.horizontal, forces.vertical, tolerance, middle);
  EXPECT_TRUE(relax(&shooting));
  return shooting;
}

// A steel rope with this many layers, taut (1 kN) or hanging in a bow.
CableProperties ropeWithLayers(double layers, double length, double tension) {
  CableProperties rope = steelRope();
  rope.bending_stiffness = tension * std::pow(length / layers, 2);
  return rope;
}

const ForcesAtA kTaut{800.0, 600.0};
const ForcesAtA kHanging{3.0, 4.0};

void expectSameShape(const CableSolution& a, const CableSolution& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance * a.length);
  EXPECT_NEAR(a.y, b.y, tolerance * a.length);
  EXPECT_NEAR(a.angle_a, b.angle_a, 10.0 * tolerance);
  EXPECT_NEAR(a.angle_b, b.angle_b, 10.0 * tolerance);
  EXPECT_NEAR(a.sag, b.sag, tolerance * a.length);
  EXPECT_NEAR(a.strained_length, b.strained_length, tolerance * a.length);
  const double thickness = a.length / 40.0;
  const double force = std::max(a.tension_a, a.tension_b);
  EXPECT_NEAR(a.max_moment, b.max_moment, 10.0 * tolerance * force * thickness);
  EXPECT_NEAR(a.max_shear, b.max_shear, 10.0 * tolerance * force);
  ASSERT_EQ(a.profile.size(), b.profile.size());
  for (std::size_t i = 0; i < a.profile.size(); ++i) {
    EXPECT_NEAR(a.profile[i].x, b.profile[i].x, tolerance * a.length);
    EXPECT_NEAR(a.profile[i].y, b.profile[i].y, tolerance * a.length);
    EXPECT_NEAR(a.profile[i].alpha, b.profile[i].alpha, 10.0 * tolerance);
    EXPECT_NEAR(a.profile[i].moment, b.profile[i].moment, 10.0 * tolerance * force * thickness);
    EXPECT_NEAR(a.profile[i].tension, b.profile[i].tension, 10.0 * tolerance * force);
    EXPECT_NEAR(a.profile[i].shear, b.profile[i].shear, 10.0 * tolerance * force);
  }
}

CableSolution measured(const MultipleShooting& shooting, int profile_points) {
  CableSolution solution;
  solution.length = shooting.length();
  solution.tension_a = std::hypot(shooting.horizontalForce(), shooting.verticalForceA());
  shooting.measure(profile_points, &solution);
  return solution;
}

TEST(QuietMiddle, AgreesWithShootingTheWholeCable) {
  RandomCables random;
  random.fewest_layers = 40.0;
  random.most_layers = 1000.0;
  random.largest_strain = 1e-3;
  int quiet = 0;
  for (int i = 0; i < 300; ++i) {
    CableCase c = random.next();
    const double tolerance = i % 4 < 2 ? 1e-10 : 1e-8;
    if (i % 3 == 0) c.cable.axial_stiffness = kInextensible;
    const std::optional<ForcesAtA> forces = catenaryForces(c.cable, c.length, c.x, c.y);
    if (!forces) continue;
    MultipleShooting closed_form;
    closed_form.start(c.cable, c.length, forces->horizontal, forces->vertical, tolerance);
    if (!closed_form.hasQuietMiddle()) continue;
    SCOPED_TRACE(::testing::Message() << c);
    ++quiet;
    ASSERT_TRUE(relax(&closed_form));
    ASSERT_TRUE(closed_form.hasQuietMiddle());
    const MultipleShooting whole = relaxed(c.cable, c.length, *forces, tolerance, Middle::kShot);
    ASSERT_FALSE(whole.hasQuietMiddle());
    expectSameShape(measured(closed_form, 23), measured(whole, 23), tolerance);
    const Eigen::Matrix<double, 2, 3> difference = closed_form.end().jacobian - whole.end().jacobian;
    EXPECT_LT(difference.leftCols<2>().norm(), 1e-8 * whole.end().jacobian.leftCols<2>().norm());
    EXPECT_LT(difference.col(2).norm(), 1e-8);
    EXPECT_EQ(closed_form.stable(), whole.stable());
    // Its sign decides, its value is summed over arcs of different number.
    EXPECT_NEAR(closed_form.areaBelowChord(), whole.areaBelowChord(), 1e-5 * c.length * c.length);
  }
  EXPECT_GT(quiet, 150);
}

// Forces between fixed ends magnify errors of the end point, most where the cable hardly stretches.
TEST(QuietMiddle, ForcesOfCablesThatHardlyStretchAgree) {
  constexpr double kTolerance = 1e-10;
  for (const double stretch : {1e-3, 1e-6, 0.0}) {
    for (const double layers : {50.0, 200.0, 1000.0}) {
      CableProperties cable = ropeWithLayers(layers, 10.0, 1000.0);
      cable.axial_stiffness = stretch > 0.0 ? 1000.0 / stretch : kInextensible;
      const MultipleShooting whole = relaxed(cable, 10.0, kTaut, kTolerance, Middle::kShot);
      const Eigen::Vector2d end = whole.end().position;
      CableSolverOptions options;
      options.tolerance = kTolerance;
      const CableSolution s = findForces(cable, 10.0, end.x(), end.y(), options);
      ASSERT_TRUE(s.status.ok()) << s.status.message;
      const double stiffness = whole.end().jacobian.leftCols<2>().inverse().norm();
      EXPECT_NEAR(s.horizontal_force, kTaut.horizontal, 1e-11 * 10.0 * stiffness + 1e-10 * 1000.0)
          << stretch << ", " << layers;
      EXPECT_NEAR(s.vertical_force_a, kTaut.vertical, 1e-11 * 10.0 * stiffness + 1e-10 * 1000.0)
          << stretch << ", " << layers;
    }
  }
}

TEST(QuietMiddle, JacobianIsThatOfDifferences) {
  for (const ForcesAtA& forces : {kTaut, kHanging}) {
    for (const double layers : {300.0, 3000.0}) {
      const double tension = std::hypot(forces.horizontal, forces.vertical);
      const CableProperties cable = ropeWithLayers(layers, 10.0, tension);
      const auto end = [&](const Eigen::Vector3d& change) {
        const MultipleShooting at =
            relaxed(cable, 10.0 + change.z(), {forces.horizontal + change.x(), forces.vertical + change.y()}, 1e-12,
                    Middle::kQuiet);
        EXPECT_TRUE(at.hasQuietMiddle());
        return at.end();
      };
      const EndPoint at = end(Eigen::Vector3d::Zero());
      for (int j = 0; j < 3; ++j) {
        const double d = 1e-3 * (j < 2 ? tension : 10.0);
        const Eigen::Vector3d step = d * Eigen::Vector3d::Unit(j);
        const auto central = [&](double k) {
          return Eigen::Vector2d(end(k * step).position - end(-k * step).position);
        };
        const Eigen::Vector2d quotient = (45.0 * central(1.0) - 9.0 * central(2.0) + central(3.0)) / (60.0 * d);
        EXPECT_LT((quotient - at.jacobian.col(j)).norm(), 3e-8 * quotient.norm()) << layers << ", column " << j;
      }
    }
  }
}

TEST(QuietMiddle, CostDoesNotGrowWithTheLayers) {
  for (const ForcesAtA& forces : {kTaut, kHanging}) {
    const double tension = std::hypot(forces.horizontal, forces.vertical);
    MultipleShooting first = relaxed(ropeWithLayers(200.0, 10.0, tension), 10.0, forces, 1e-8, Middle::kQuiet);
    ASSERT_TRUE(first.hasQuietMiddle());
    for (const double layers : {1e3, 1e4, 1e5, 1e6}) {
      MultipleShooting shooting = relaxed(ropeWithLayers(layers, 10.0, tension), 10.0, forces, 1e-8, Middle::kQuiet);
      EXPECT_LE(shooting.segments(), first.segments());
      EXPECT_LE(shooting.steps(), first.steps());
    }
  }
}

TEST(QuietMiddle, AMillionLayersAreACatenary) {
  for (const double length : {9.99, 10.01, 12.0}) {
    for (const double y : {-6.0, 0.0, 6.0}) {
      CableProperties cable = steelRope();
      const double x = std::sqrt(100.0 - y * y);
      const std::optional<ForcesAtA> catenary = catenaryForces(cable, length, x, y);
      ASSERT_TRUE(catenary);
      const double tension = std::hypot(catenary->horizontal, catenary->vertical);
      cable.bending_stiffness = tension * std::pow(length / 1e6, 2);
      CableSolverOptions options;
      options.profile_points = 50;
      const CableSolution s = findForces(cable, length, x, y, options);
      ASSERT_TRUE(s.status.ok()) << s.status.message;
      EXPECT_TRUE(isFinite(s));
      EXPECT_NEAR(s.horizontal_force, catenary->horizontal, 1e-7 * tension);
      EXPECT_NEAR(s.vertical_force_a, catenary->vertical, 1e-7 * tension);
      EXPECT_LE(s.iterations, 4);
    }
  }
}

TEST(QuietMiddle, IsLeftWhereItIsNotQuiet) {
  const CableProperties rope = steelRope();
  MultipleShooting shooting;
  shooting.start(ropeWithLayers(15.0, 10.0, 1000.0), 10.0, 800.0, 600.0, 1e-8);  // layers fill the cable
  EXPECT_FALSE(shooting.hasQuietMiddle());
  shooting.start(rope, 20.0, 0.05, 6.0, 1e-8);  // a narrow loop
  EXPECT_FALSE(shooting.hasQuietMiddle());
  shooting.start(rope, 20.0, -1.0, 6.0, 1e-8);  // compressed at its lowest point
  EXPECT_FALSE(shooting.hasQuietMiddle());
  shooting.start(rope, 10.0, 0.0, -500.0, 1e-8);  // vertical and taut: nothing is wrong with that
  EXPECT_TRUE(shooting.hasQuietMiddle());
  ASSERT_TRUE(relax(&shooting));
  EXPECT_NEAR(shooting.end().position.x(), 0.0, 1e-14);
  EXPECT_NEAR(shooting.end().jacobian(0, 0), catenaryHorizontalCompliance(rope, 0.0, -500.0, 10.0), 1e-2);
}

TEST(QuietMiddle, MeshFollowsTheForces) {
  const CableProperties rope = steelRope();
  for (const ForcesAtA& to : {ForcesAtA{20.0, 15.0}, ForcesAtA{20000.0, 9000.0}, ForcesAtA{2.0, 3.0}}) {
    MultipleShooting shooting = relaxed(rope, 10.0, kTaut, 1e-9, Middle::kQuiet);
    ASSERT_TRUE(shooting.hasQuietMiddle());
    constexpr int kSteps = 8;
    for (int i = 1; i <= kSteps; ++i) {
      const double share = static_cast<double>(i) / kSteps;
      const double h = kTaut.horizontal * std::pow(to.horizontal / kTaut.horizontal, share);
      const double v = kTaut.vertical * std::pow(to.vertical / kTaut.vertical, share);
      shooting.step({h - shooting.horizontalForce(), v - shooting.verticalForceA(), 0.0}, 1.0);
      ASSERT_TRUE(relax(&shooting)) << h;
    }
    const MultipleShooting fresh = relaxed(rope, 10.0, to, 1e-9, Middle::kShot);
    EXPECT_LT((shooting.end().position - fresh.end().position).norm(), 1e-8);
    EXPECT_EQ(shooting.hasQuietMiddle(), to.horizontal > 5.0);
  }
}

TEST(QuietMiddle, OtherPropertiesMeanShots) {
  CableProperties rope = steelRope();
  MultipleShooting shooting = relaxed(rope, 10.0, kTaut, 1e-9, Middle::kQuiet);
  ASSERT_TRUE(shooting.hasQuietMiddle());
  rope.bending_stiffness *= 1.5;
  shooting.changeProperties(rope);
  EXPECT_FALSE(shooting.hasQuietMiddle());
  ASSERT_TRUE(relax(&shooting));
  const MultipleShooting fresh = relaxed(rope, 10.0, kTaut, 1e-9, Middle::kQuiet);
  EXPECT_LT((shooting.end().position - fresh.end().position).norm(), 1e-8);
}

TEST(MultipleShooting, GoesBackToAnEarlierStateAndKeepsCount) {
  MultipleShooting shooting = relaxed(steelRope(), 10.0, kTaut, 1e-9, Middle::kQuiet);
  const MultipleShooting earlier = shooting;
  const Eigen::Vector2d end = shooting.end().position;
  shooting.step({30.0, -20.0, 0.1}, 1.0);
  ASSERT_TRUE(relax(&shooting));
  ASSERT_GT((shooting.end().position - end).norm(), 1e-3);
  const IntegrationWork work = shooting.work();
  shooting.restore(earlier);
  EXPECT_EQ(shooting.horizontalForce(), kTaut.horizontal);
  EXPECT_EQ(shooting.verticalForceA(), kTaut.vertical);
  EXPECT_EQ(shooting.length(), 10.0);
  EXPECT_EQ(shooting.end().position, end);
  EXPECT_EQ(shooting.work().steps, work.steps);
  EXPECT_GT(work.steps, earlier.work().steps);
}

TEST(MultipleShooting, RefusesMoreSegmentsThanCanBeAfforded) {
  const double layers = 1.1 * kMaxSegments * kLayersPerSegment;
  MultipleShooting shooting;
  const CableProperties rope = ropeWithLayers(layers, 10.0, 1000.0);
  shooting.start(rope, 10.0, kTaut.horizontal, kTaut.vertical, 1e-8, Middle::kShot);
  EXPECT_TRUE(shooting.tooManySegments());
  EXPECT_FALSE(shooting.linearise(false));
  shooting.start(rope, 10.0, kTaut.horizontal, kTaut.vertical, 1e-8);
  EXPECT_FALSE(shooting.tooManySegments());
  EXPECT_TRUE(shooting.linearise(true));
}

// A start from the straight line: in equilibrium, and stable up to Euler's load with its ends held.
TEST(MultipleShooting, AStraightColumnIsStableUpToEulersLoad) {
  CableProperties column{1e6, 50.0, 0.0};
  const double length = 2.0;
  const double buckling = column.bending_stiffness * std::pow(M_PI / length, 2);
  for (const double load : {-2.0, 0.5, 0.98, 1.02, 3.0}) {
    MultipleShooting shooting;
    const double chord = length * (1.0 - load * buckling / column.axial_stiffness);
    shooting.startStraight(column, length, 0.6 * chord, -0.8 * chord, 1e-10);
    ASSERT_TRUE(shooting.linearise(true));
    EXPECT_NEAR(shooting.bucklingForce(), buckling, 1e-12 * buckling);
    EXPECT_LT(shooting.momentDefect(), 1e-9 * buckling * length);
    EXPECT_LT((shooting.end().position - chord * Eigen::Vector2d(0.6, -0.8)).norm(), 1e-9);
    EXPECT_EQ(shooting.stable(), load < 1.0) << load;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The stability map in small (docs/stability.md): cables from everywhere, all three problems, judged by collocation;
// where single shooting ends elsewhere; and no jumps where the mesh changes.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "cable/bending.h"
#include "cable_verdict.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "collocation.h"
#include "known_cables.h"
#include "single_shooting.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kCables = 400;

struct Count {
  int asked = 0;
  int solved = 0;

  void add(const ExtremeCable& cable, const char* problem, const Judged& judged) {
    if (judged.outcome == Outcome::kNotAsked) return;
    ++asked;
    if (judged.outcome == Outcome::kSolved) ++solved;
    EXPECT_NE(judged.outcome, Outcome::kUnverified) << problem << ": " << cable;
    EXPECT_NE(judged.outcome, Outcome::kWrongBranch) << problem << ": " << cable;
    EXPECT_TRUE(std::isfinite(judged.error)) << problem << ": " << cable;
    if (judged.outcome != Outcome::kRefused) return;
    EXPECT_FALSE(judged.message.empty()) << problem << ": " << cable;
  }
};

TEST(Extremes, NearlyEveryCableIsSolvedOnTheRightBranch) {
  Count position, forces, length;
  JudgeOptions options;
  options.timeout = 30.0;  // time decides nothing here
  const std::vector<ExtremeCable> cables = extremeCables(kCables);
  for (std::size_t i = 0; i < cables.size(); ++i) {
    if (!cables[i].corner().empty()) continue;
    options.hinted = (i / 4) % 2 == 1;
    const CableVerdict verdict = judge(cables[i], options);
    position.add(cables[i], "problem 1", verdict.position);
    forces.add(cables[i], "problem 2", verdict.forces);
    length.add(cables[i], "problem 3", verdict.length);
  }
  EXPECT_GT(forces.asked, kCables * 9 / 10);
  for (const Count& count : {position, forces, length}) EXPECT_GE(count.solved, 0.995 * count.asked);
}

// Single shooting from the catenary: no moment at B, B in its place, and not what hangs there.
TEST(Extremes, SingleShootingLandsOnAnotherEquilibrium) {
  for (const double length : {5.592, 5.607, 5.623, 5.647, 5.671, 5.703, 5.747}) {
    const SingleShooting single = shootSingly(paperBar(), length, 5.0, -2.5, 1e-10);
    ASSERT_TRUE(single.converged) << length;
    if (length == 5.592) {
      EXPECT_NEAR(single.h, -1701.42, 0.01);
    }
    const CableSolution s = findForces(paperBar(), length, 5.0, -2.5, {});
    ASSERT_TRUE(s.status.ok()) << s.status.message;
    EXPECT_LT(single.h, s.horizontal_force - 1000.0) << length;
    const VerifiedCable held =
        verify({paperBar(), length, 5.0, -2.5, s.horizontal_force, s.vertical_force_a, {}}, Kept::kEndPoint);
    ASSERT_TRUE(held.converged) << length;
    EXPECT_TRUE(held.sags()) << length;
    EXPECT_NEAR(s.horizontal_force, held.h, 1e-6 * s.tension_a) << length;
  }
}

TEST(Extremes, SingleShootingIsWrongOrFailsOnMostOfTheMap) {
  int solved = 0;
  int wrong = 0;
  int both = 0;
  const std::vector<ExtremeCable> cables = extremeCables(kCables);
  for (const ExtremeCable& c : cables) {
    if (!c.corner().empty()) continue;
    const SingleShooting single = shootSingly(c.cable, c.length, c.x, c.y, 1e-8);
    const CableSolution s = findForces(c.cable, c.length, c.x, c.y, {});
    if (!single.converged || !s.status.ok()) continue;
    ++both;
    const double tension = std::max(s.tension_a, s.tension_b);
    const double difference = std::hypot(single.h - s.horizontal_force, single.v - s.vertical_force_a) / tension;
    if (difference < 1e-4) ++solved;
    if (difference < 1e-2) continue;
    ++wrong;
    const VerifiedCable held =
        verify({c.cable, c.length, c.x, c.y, s.horizontal_force, s.vertical_force_a, {}}, Kept::kEndPoint);
    if (held.converged && std::abs(held.h - s.horizontal_force) < 1e-4 * tension) {
      EXPECT_TRUE(held.sags()) << c;
    }
  }
  EXPECT_GT(wrong, 5);
  EXPECT_GT(both, solved);
  EXPECT_LT(solved, kCables / 3);
}

struct Path {
  const char* name;
  CableProperties cable;
  double chord, inclination, from, to;  // L/chord
};

// Along each path the number of segments changes, and shots give way to quiet stretches and back; forces must follow
// their derivative, with no more of a jump than the tolerance allows.
TEST(Extremes, ForcesDoNotJumpWhereTheMeshChanges) {
  constexpr double kTolerance = 1e-8;
  constexpr int kSteps = 150;
  const Path paths[] = {{"to few layers", {1e5, 2.0, 0.6}, 10.0, 0.4, 0.99, 1.01},
                        {"slack", {1e5, 0.01, 0.6}, 10.0, 0.4, 1.0, 1.6},
                        {"to a sharp loop", {1e6, 1e-4, 0.6}, 2.0, 0.0, 1.02, 4.0},
                        {"stiff", {1e6, 50.0, 5.0}, 5.0, -0.5, 0.999, 1.05}};
  for (const Path& path : paths) {
    const double x = path.chord * std::cos(path.inclination);
    const double y = path.chord * std::sin(path.inclination);
    int meshes = 0;
    int last_segments = 0;
    CableSolution last;
    CableSolverOptions options;
    options.tolerance = kTolerance;
    for (int i = 0; i <= kSteps; ++i) {
      const double length = path.chord * (path.from + (path.to - path.from) * i / kSteps);
      MultipleShooting shooting;
      SolveLimits bending;
      bending.tolerance = kTolerance;
      ASSERT_TRUE(solveBendingForces(path.cable, length, x, y, bending, &shooting).status.ok()) << path.name;
      if (shooting.segments() != last_segments) ++meshes;
      last_segments = shooting.segments();
      const CableSolution here = findForces(path.cable, length, x, y, options);
      // A hair's breadth away the mesh may be another one.
      const double ds = 1e-9 * length;
      const CableSolution next = findForces(path.cable, length + ds, x, y, options);
      ASSERT_TRUE(here.status.ok() && next.status.ok()) << path.name << " L/chord " << length / path.chord;
      const Eigen::Vector2d jump(next.horizontal_force - here.horizontal_force - ds * here.force_jacobian(0, 2),
                                 next.vertical_force_a - here.vertical_force_a - ds * here.force_jacobian(1, 2));
      EXPECT_LT(jump.norm(), kTolerance * std::max(here.tension_a, here.tension_b))
          << path.name << " L/chord " << length / path.chord;
    }
    EXPECT_GT(meshes, 1) << path.name;
    RecordProperty(path.name, meshes);
  }
}

// The same cable shot whole and with quiet stretches, on either side of where the solver changes from one to the other.
TEST(Extremes, ShotAndQuietMeshesAgree) {
  const CableProperties rope{1e5, 0.01, 0.6};
  for (const double ratio : {0.99, 1.05, 1.5}) {
    const double length = 10.0 * ratio;
    MultipleShooting quiet;
    ASSERT_TRUE(solveBendingForces(rope, length, 9.0, 4.0, {}, &quiet).status.ok());
    ASSERT_TRUE(quiet.hasQuietMiddle()) << ratio;
    MultipleShooting whole;
    whole.start(rope, length, quiet.horizontalForce(), quiet.verticalForceA(), 1e-8, Middle::kShot);
    ASSERT_TRUE(followBendingForces(length, 9.0, 4.0, {}, &whole).status.ok());
    EXPECT_FALSE(whole.hasQuietMiddle());
    const double tension = std::hypot(whole.horizontalForce(), whole.verticalForceA());
    EXPECT_NEAR(quiet.horizontalForce(), whole.horizontalForce(), 1e-8 * tension) << ratio;
    EXPECT_NEAR(quiet.verticalForceA(), whole.verticalForceA(), 1e-8 * tension) << ratio;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

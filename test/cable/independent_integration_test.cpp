// Random cables of all inclinations, taut and slack, stiff and limp: what BENDING returns satisfies the paper's
// equations, re-integrated by other means than the solver's.
//
// Single shooting cannot check a whole cable: errors grow as exp(kappa L). But between two neighbouring points
// of a fine profile it can, and moment balance, paper equation (9), holds on the profile as it stands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cable_equations.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "finite_solution.h"
#include "random_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kCables = 400;
constexpr double kTolerance = 1e-10;

struct Solved {
  CableCase given;
  CableSolution solution;
};

// Solved once for all tests; those without an answer are the subject of the first test alone.
const std::vector<Solved>& solvedCables() {
  static const std::vector<Solved> all = [] {
    std::vector<Solved> result;
    RandomCables random;
    for (int i = 0; i < kCables; ++i) {
      const CableCase c = random.next();
      CableSolverOptions options;
      options.tolerance = kTolerance;
      // About ten points to the thinnest bending layer.
      options.profile_points = 40 + 10 * static_cast<int>(2.0 * c.layers);
      result.push_back({c, findForces(c.cable, c.length, c.x, c.y, options)});
    }
    return result;
  }();
  return all;
}

// Scale of moments: largest force times thickness of the bending layer there.
double momentScale(const Solved& s) {
  const double force = std::max(s.solution.tension_a, s.solution.tension_b);
  return std::max(std::sqrt(force * s.given.cable.bending_stiffness), s.solution.max_moment);
}

TEST(RandomCable, HasAnAnswerOrASentence) {
  int answered = 0;
  for (const Solved& s : solvedCables()) {
    if (s.solution.status.ok()) {
      ++answered;
    } else {
      ADD_FAILURE() << s.given << ": " << s.solution.status.message;
      EXPECT_FALSE(s.solution.status.message.empty()) << s.given;
    }
  }
  EXPECT_EQ(answered, kCables);
}

TEST(RandomCable, HoldsNoNaN) {
  for (const Solved& s : solvedCables()) EXPECT_TRUE(isFinite(s.solution)) << s.given;
}

TEST(RandomCable, ClosesWithMomentFreeEnds) {
  for (const Solved& s : solvedCables()) {
    if (!s.solution.status.ok()) continue;
    const std::vector<ProfilePoint>& profile = s.solution.profile;
    EXPECT_NEAR(profile.back().x, s.given.x, 1e-8 * s.given.length) << s.given;
    EXPECT_NEAR(profile.back().y, s.given.y, 1e-8 * s.given.length) << s.given;
    EXPECT_NEAR(s.solution.x, s.given.x, 1e-9 * s.given.length) << s.given;
    EXPECT_NEAR(s.solution.y, s.given.y, 1e-9 * s.given.length) << s.given;
    EXPECT_NEAR(profile.front().moment, 0.0, 1e-8 * momentScale(s)) << s.given;
    EXPECT_NEAR(profile.back().moment, 0.0, 1e-8 * momentScale(s)) << s.given;
  }
}

// From each point of the profile to the next with ten Runge-Kutta steps of the equations in SI units.
TEST(RandomCable, RunsFromEachPointToTheNextByThePapersEquations) {
  for (const Solved& s : solvedCables()) {
    if (!s.solution.status.ok()) continue;
    const double moment = momentScale(s);
    double worst = 0.0;
    for (std::size_t i = 1; i < s.solution.profile.size(); ++i) {
      const ProfilePoint& a = s.solution.profile[i - 1];
      const ProfilePoint& b = s.solution.profile[i];
      const CableState<double> end =
          integrateCable<double>(s.given.cable, s.solution.horizontal_force, s.solution.vertical_force_a, a.s, b.s,
                                 {a.alpha, a.moment, a.x, a.y}, 10);
      worst = std::max({worst, std::abs(end[0] - b.alpha), std::abs(end[1] - b.moment) / moment,
                        std::abs(end[2] - b.x) / s.given.length, std::abs(end[3] - b.y) / s.given.length});
    }
    EXPECT_LT(worst, 1e-8) << s.given;
  }
}

// M = V x + H y - q s x + q int_0^s x ds': the integral by Hermite quadrature on the profile.
TEST(RandomCable, BalancesMomentsByEquation9) {
  for (const Solved& s : solvedCables()) {
    if (!s.solution.status.ok()) continue;
    const CableProperties& cable = s.given.cable;
    const CableSolution& c = s.solution;
    const auto slope = [&](const ProfilePoint& p) {  // dx/ds
      return (1.0 + p.tension / cable.axial_stiffness) * std::cos(p.alpha);
    };
    const double ds = c.profile[1].s - c.profile[0].s;
    double integral = 0.0;
    double worst = 0.0;
    for (std::size_t i = 0; i < c.profile.size(); ++i) {
      const ProfilePoint& p = c.profile[i];
      if (i > 0) {
        const ProfilePoint& o = c.profile[i - 1];
        integral += 0.5 * ds * (o.x + p.x) + ds * ds / 12.0 * (slope(o) - slope(p));
      }
      const double moment = c.vertical_force_a * p.x + c.horizontal_force * p.y - cable.weight * (p.s * p.x - integral);
      worst = std::max(worst, std::abs(moment - p.moment));
    }
    // The right side is a small difference of moments of the whole cable.
    const double whole = std::max(c.tension_a, c.tension_b) * s.given.length;
    EXPECT_LT(worst, 1e-8 * whole) << s.given;
  }
}

// The point's own tension and shear are components of the force (H, q s - V).
TEST(RandomCable, SplitsItsForceIntoTensionAndShear) {
  for (const Solved& s : solvedCables()) {
    for (const ProfilePoint& p : s.solution.profile) {
      const double vertical = s.given.cable.weight * p.s - s.solution.vertical_force_a;
      const double horizontal = s.solution.horizontal_force;
      const double scale = 1e-12 * (std::abs(horizontal) + std::abs(vertical) + s.solution.tension_a);
      ASSERT_NEAR(p.tension, horizontal * std::cos(p.alpha) + vertical * std::sin(p.alpha), scale) << s.given;
      ASSERT_NEAR(p.shear, vertical * std::cos(p.alpha) - horizontal * std::sin(p.alpha), scale) << s.given;
    }
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

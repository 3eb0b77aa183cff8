// Profiles and the measures taken from them: sag, largest moment and shear, strained length, end angles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "finite_solution.h"
#include "known_cables.h"
#include "random_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr Model kModels[] = {Model::kStraightElastic, Model::kCatenaryInextensible, Model::kCatenary,
                             Model::kBendingInextensible, Model::kBending};

CableSolverOptions options(Model model, int profile_points, double tolerance = 1e-10) {
  CableSolverOptions result;
  result.model = model;
  result.profile_points = profile_points;
  result.tolerance = tolerance;
  return result;
}

// Slack ropes, bars, wires; taut where the model needs that.
std::vector<CableCase> cablesFor(Model model) {
  std::vector<CableCase> result;
  RandomCables random;
  random.least_strain = 1e-4;
  random.most_layers = 200.0;
  while (result.size() < 30) {
    const CableCase c = random.next();
    const bool taut = c.length < c.chord();
    if ((taut && isInextensible(model)) || (!taut && isStraight(model))) continue;
    result.push_back(c);
  }
  return result;
}

class Measures : public ::testing::TestWithParam<Model> {};

TEST_P(Measures, ProfilesAreUniformInSWithBothEnds) {
  for (const CableCase& c : cablesFor(GetParam())) {
    for (const int points : {2, 3, 7, 100}) {
      const CableSolution s = findForces(c.cable, c.length, c.x, c.y, options(GetParam(), points));
      ASSERT_TRUE(s.status.ok()) << c << ": " << s.status.message;
      ASSERT_EQ(s.profile.size(), static_cast<std::size_t>(points)) << c;
      EXPECT_TRUE(isFinite(s)) << c;
      for (int i = 0; i < points; ++i) {
        EXPECT_NEAR(s.profile[i].s, c.length * i / (points - 1), 1e-12 * c.length) << c;
      }
      const ProfilePoint& a = s.profile.front();
      const ProfilePoint& b = s.profile.back();
      EXPECT_EQ(a.x, 0.0);
      EXPECT_EQ(a.y, 0.0);
      EXPECT_NEAR(b.x, c.x, 1e-8 * c.length) << c;
      EXPECT_NEAR(b.y, c.y, 1e-8 * c.length) << c;
      EXPECT_NEAR(a.alpha, s.angle_a, 1e-9) << c;
      EXPECT_NEAR(b.alpha, s.angle_b, 1e-8) << c;
    }
  }
}

TEST_P(Measures, NoProfileUnlessAskedFor) {
  for (const CableCase& c : cablesFor(GetParam())) {
    EXPECT_TRUE(findForces(c.cable, c.length, c.x, c.y, options(GetParam(), 0)).profile.empty());
  }
}

// The measures do not come from the profile; a fine profile must show the same.
TEST_P(Measures, AreThoseOfAFineProfile) {
  constexpr int kPoints = 8001;
  for (const CableCase& c : cablesFor(GetParam())) {
    const CableSolution s = findForces(c.cable, c.length, c.x, c.y, options(GetParam(), kPoints));
    ASSERT_TRUE(s.status.ok()) << c << ": " << s.status.message;
    double sag = 0.0, moment = 0.0, shear = 0.0, stretched = 0.0;
    for (int i = 0; i < kPoints; ++i) {
      const ProfilePoint& p = s.profile[i];
      sag = std::max(sag, std::abs(p.x * c.y - p.y * c.x) / c.chord());
      moment = std::max(moment, std::abs(p.moment));
      shear = std::max(shear, std::abs(p.shear));
      const double weight = i == 0 || i == kPoints - 1 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;  // Simpson's rule
      const double strain = isInextensible(GetParam()) ? 0.0 : p.tension / c.cable.axial_stiffness;
      stretched += weight / 3.0 * (1.0 + strain) * c.length / (kPoints - 1);
    }
    EXPECT_NEAR(s.strained_length, stretched, 1e-8 * c.length) << c;
    EXPECT_NEAR(s.sag, sag, 1e-5 * sag + 1e-9 * c.length) << c;
    if (isBending(GetParam())) {
      EXPECT_NEAR(s.max_moment, moment, 1e-4 * moment + 1e-9 * s.tension_a * c.length) << c;
      EXPECT_NEAR(s.max_shear, shear, 1e-4 * shear + 1e-9 * s.tension_a) << c;
    } else {
      EXPECT_EQ(s.max_moment, 0.0);
      EXPECT_EQ(s.max_shear, 0.0);
      EXPECT_EQ(moment, 0.0);
      EXPECT_EQ(shear, 0.0);
    }
  }
}

// Whether a profile is asked for, and how fine, changes nothing else.
TEST_P(Measures, DoNotDependOnTheProfile) {
  for (const CableCase& c : cablesFor(GetParam())) {
    const CableSolution none = findForces(c.cable, c.length, c.x, c.y, options(GetParam(), 0));
    const CableSolution fine = findForces(c.cable, c.length, c.x, c.y, options(GetParam(), 500));
    EXPECT_EQ(none.horizontal_force, fine.horizontal_force) << c;
    EXPECT_EQ(none.sag, fine.sag) << c;
    EXPECT_EQ(none.max_moment, fine.max_moment) << c;
    EXPECT_EQ(none.max_shear, fine.max_shear) << c;
    EXPECT_EQ(none.strained_length, fine.strained_length) << c;
  }
}

TEST_P(Measures, AProfileHoldsStillAtLooseTolerances) {
  for (const CableCase& c : cablesFor(GetParam())) {
    const CableSolution loose = findForces(c.cable, c.length, c.x, c.y, options(GetParam(), 41, 1e-6));
    const CableSolution tight = findForces(c.cable, c.length, c.x, c.y, options(GetParam(), 41, 1e-11));
    ASSERT_TRUE(loose.status.ok() && tight.status.ok()) << c;
    for (std::size_t i = 0; i < tight.profile.size(); ++i) {
      ASSERT_NEAR(loose.profile[i].x, tight.profile[i].x, 1e-4 * c.length) << c << ", point " << i;
      ASSERT_NEAR(loose.profile[i].y, tight.profile[i].y, 1e-4 * c.length) << c << ", point " << i;
    }
  }
}

TEST_P(Measures, HoldForTheOtherProblemsToo) {
  const Model model = GetParam();
  const CableSolution first = findPosition(steelRope(), 8.0, 30.0, 4.0, options(model, 5));
  ASSERT_TRUE(first.status.ok()) << first.status.message;
  EXPECT_EQ(first.profile.size(), 5u);
  EXPECT_NEAR(first.profile.back().x, first.x, 1e-9);
  const CableSolution third = findLength(steelRope(), 7.0, -4.0, 30.0, 0.0, options(model, 5));
  ASSERT_TRUE(third.status.ok()) << third.status.message;
  EXPECT_EQ(third.profile.size(), 5u);
  EXPECT_NEAR(third.profile.back().x, 7.0, 1e-8);
  EXPECT_NEAR(third.profile.back().y, -4.0, 1e-8);
}

std::string nameOf(const ::testing::TestParamInfo<Model>& test) { return modelName(test.param); }

TEST_P(Measures, TheIntegratorsWorkIsCountedAndGrowsWithAccuracy) {
  int steps = 0;
  int finer_steps = 0;
  for (const CableCase& c : cablesFor(GetParam())) {
    const CableSolution s = findForces(c.cable, c.length, c.x, c.y, options(GetParam(), 0, 1e-5));
    ASSERT_TRUE(s.status.ok()) << c << ": " << s.status.message;
    if (!isBending(GetParam()) || c.cable.bending_stiffness == 0.0) {
      EXPECT_EQ(s.integrator_steps, 0) << c;
    }
    EXPECT_GE(s.evaluations, 6 * s.integrator_steps) << c;
    steps += s.integrator_steps;
    finer_steps += findForces(c.cable, c.length, c.x, c.y, options(GetParam(), 0, 1e-10)).integrator_steps;
  }
  EXPECT_EQ(finer_steps > steps, isBending(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(EveryRung, Measures, ::testing::ValuesIn(kModels), nameOf);

// Angles begin in (-pi, pi] and go on without jumps; what is stated as largest is.
TEST(Measure, AnglesAndLargestValuesHoldForTheProfile) {
  struct Case {
    CableProperties cable;
    double length, x, y;
  };
  const Case cases[] = {{{1e8, 5e4, 10.0}, 4.0003361, 0.05, -4.0},
                        {steelRope(), 3.0, 0.0, -2.0},
                        {steelRope(), 8.5, 7.0, -4.0},
                        {paperBar(), 6.5, 5.0, -2.5},
                        {paperBar(), 12.0, 1.0, 3.0},
                        {steelRope(), 3.0, 0.0, 0.0}};
  for (const Case& c : cases) {
    CableSolverOptions options;
    options.profile_points = 201;
    const CableSolution s = findForces(c.cable, c.length, c.x, c.y, options);
    ASSERT_TRUE(s.status.ok()) << s.status.message;
    EXPECT_GT(s.angle_a, -M_PI);
    EXPECT_LE(s.angle_a, M_PI);
    EXPECT_NEAR(s.profile.front().alpha, s.angle_a, 1e-9);
    EXPECT_NEAR(s.profile.back().alpha, s.angle_b, 1e-9);
    options.profile_points = 0;
    const CableSolution bare = findForces(c.cable, c.length, c.x, c.y, options);
    for (std::size_t k = 0; k < s.profile.size(); ++k) {
      if (k > 0) {
        EXPECT_LT(std::abs(s.profile[k].alpha - s.profile[k - 1].alpha), 1.0) << k;
      }
      EXPECT_LE(std::abs(s.profile[k].moment), s.max_moment);
      EXPECT_LE(std::abs(s.profile[k].shear), s.max_shear);
      // Without a profile the extremes of the steps' cubics say the same.
      EXPECT_LE(std::abs(s.profile[k].moment), bare.max_moment * (1.0 + 1e-8));
    }
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

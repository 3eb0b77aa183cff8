// CATENARY_CORRECTED and the estimates of what every rung neglects, against closed forms and against BENDING.
#include <gtest/gtest.h>

#include <cmath>

#include "cable/bending_expansion.h"
#include "cable/rung_error.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

CableSolverOptions options(Model model, double tolerance = 1e-8) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = tolerance;
  return result;
}

// A cable under given forces, from taut to hanging, from a few bending layers to a thousand.
struct LoadedCable {
  CableProperties cable;
  double length = 0.0, h = 0.0, v = 0.0;
};

LoadedCable randomLoaded(Dice* dice, double most_sag) {
  const auto power = [&](double low, double high) { return std::pow(10.0, dice->uniform(low, high)); };
  LoadedCable c;
  c.length = power(0.0, 2.0);
  c.cable.weight = power(-1.0, 1.0);
  const double tension = c.cable.weight * c.length / power(-3.0, most_sag);
  const double angle = dice->uniform(-1.4, 1.4);
  c.h = tension * std::cos(angle);
  c.v = tension * std::sin(angle) + 0.5 * c.cable.weight * c.length;
  c.cable.axial_stiffness = std::max(tension, c.cable.weight * c.length) / power(-6.0, -2.0);
  c.cable.bending_stiffness = std::hypot(c.h, c.v) * std::pow(c.length / power(0.5, 3.0), 2);
  return c;
}

Eigen::Vector2d trueEffect(const LoadedCable& c) {
  const CableSolution bending = findPosition(c.cable, c.length, c.h, c.v, options(Model::kBending, 1e-12));
  const EndPoint catenary = catenaryEnd(c.cable, c.h, c.v, c.length);
  EXPECT_TRUE(bending.status.ok()) << bending.status.message;
  return Eigen::Vector2d(bending.x, bending.y) - catenary.position;
}

TEST(CatenaryCorrected, AgreesWithTheIntegralInClosedFormWithoutStretch) {
  const CableProperties rope{std::numeric_limits<double>::infinity(), 0.44, 0.63};
  for (const double h : {0.3, 3.0, 30.0, 300.0}) {
    const double length = 9.0, v = 4.0;
    const double a = std::atan2(-v, h), b = std::atan2(rope.weight * length - v, h);
    const auto primitive = [](double alpha) {
      return Eigen::Vector2d(alpha / 4.0 + std::sin(2.0 * alpha) / 4.0 + std::sin(4.0 * alpha) / 16.0,
                             -std::pow(std::cos(alpha), 4) / 2.0);
    };
    const Eigen::Vector2d exact = rope.bending_stiffness * rope.weight / (h * h) * (primitive(b) - primitive(a));
    EXPECT_LT((firstOrderBending(rope, h, v, length).position - exact).norm(), 1e-10 * exact.norm()) << h;
  }
}

TEST(CatenaryCorrected, HasTheDerivativesOfItsEnd) {
  Dice dice(11);
  for (int k = 0; k < 300; ++k) {
    const LoadedCable c = randomLoaded(&dice, 1.0);
    const EndPoint end = correctedCatenaryEnd(c.cable, c.h, c.v, c.length);
    const double df = 1e-6 * c.h, dl = 1e-6 * c.length;
    const auto at = [&](double h, double v, double l) { return correctedCatenaryEnd(c.cable, h, v, l).position; };
    Eigen::Matrix<double, 2, 3> differences;
    differences << (at(c.h + df, c.v, c.length) - at(c.h - df, c.v, c.length)) / (2.0 * df),
        (at(c.h, c.v + df, c.length) - at(c.h, c.v - df, c.length)) / (2.0 * df),
        (at(c.h, c.v, c.length + dl) - at(c.h, c.v, c.length - dl)) / (2.0 * dl);
    for (int column = 0; column < 3; ++column) {
      EXPECT_LT((differences - end.jacobian).col(column).norm(), 1e-6 * end.jacobian.col(column).norm() + 1e-9)
          << k << ", column " << column;
    }
  }
}

TEST(CatenaryCorrected, ItsThreeProblemsAgree) {
  for (const CableProperties& rope : {steelRope(), CableProperties{2.87e5, 0.044, 0.63}}) {
    const CableSolution forces = findForces(rope, 8.2, 7.0, -4.0, options(Model::kCatenaryCorrected));
    ASSERT_TRUE(forces.status.ok()) << forces.status.message;
    EXPECT_LT(forces.closure_residual, 1e-12);
    const CableSolution position =
        findPosition(rope, 8.2, forces.horizontal_force, forces.vertical_force_a, options(Model::kCatenaryCorrected));
    EXPECT_NEAR(position.x, 7.0, 1e-11);
    EXPECT_NEAR(position.y, -4.0, 1e-11);
    const CableSolution length =
        findLength(rope, 7.0, -4.0, forces.tension_a, 8.2, options(Model::kCatenaryCorrected, 1e-10));
    ASSERT_TRUE(length.status.ok()) << length.status.message;
    EXPECT_NEAR(length.length, 8.2, 1e-7);
  }
}

TEST(CatenaryCorrected, IsTheCatenaryWithoutBendingStiffnessOrWeight) {
  for (CableProperties rope : {CableProperties{2.87e5, 0.0, 0.63}, CableProperties{2.87e5, 0.44, 0.0}}) {
    const CableSolution corrected = findForces(rope, 8.0, 7.0, -4.0, options(Model::kCatenaryCorrected));
    const CableSolution catenary = findForces(rope, 8.0, 7.0, -4.0, options(Model::kCatenary));
    ASSERT_TRUE(corrected.status.ok()) << corrected.status.message;
    EXPECT_NEAR(corrected.horizontal_force, catenary.horizontal_force, 1e-12 * catenary.tension_a);
    EXPECT_NEAR(corrected.vertical_force_a, catenary.vertical_force_a, 1e-12 * catenary.tension_a);
  }
}

TEST(CatenaryCorrected, ItsProfileMeetsBothEndsAndBendsAsTheBendingCableDoes) {
  const CableSolution corrected = [] {
    CableSolverOptions asked = options(Model::kCatenaryCorrected);
    asked.profile_points = 201;
    return findForces(steelRope(), 8.1, 7.0, -4.0, asked);
  }();
  CableSolverOptions asked = options(Model::kBending);
  asked.profile_points = 201;
  const CableSolution bending = findForces(steelRope(), 8.1, 7.0, -4.0, asked);
  ASSERT_TRUE(corrected.status.ok() && bending.status.ok());
  EXPECT_NEAR(corrected.profile.back().x, 7.0, 1e-10);
  EXPECT_NEAR(corrected.profile.back().y, -4.0, 1e-10);
  EXPECT_NEAR(corrected.max_moment, bending.max_moment, 0.1 * bending.max_moment);
  EXPECT_NEAR(corrected.max_shear, bending.max_shear, 0.1 * bending.max_shear);
  for (std::size_t i = 0; i < corrected.profile.size(); ++i) {
    const Eigen::Vector2d apart(corrected.profile[i].x - bending.profile[i].x,
                                corrected.profile[i].y - bending.profile[i].y);
    EXPECT_LT(apart.norm(), 2e-3) << i;
    EXPECT_NEAR(corrected.profile[i].moment, bending.profile[i].moment, 0.15 * bending.max_moment) << i;
  }
}

TEST(CatenaryCorrected, SaysSoWhereBendingIsNoSmallEffect) {
  // The paper's bar, hanging.
  const CableProperties bar = paperBar();
  const CableSolution refused = findForces(bar, 7.0, 5.0, -2.5, options(Model::kCatenaryCorrected));
  EXPECT_EQ(refused.status.code, Code::kNotConverged);
  EXPECT_NE(refused.status.message.find("bending model"), std::string::npos) << refused.status.message;
}

// The estimate is to leading order, so it is judged by its ratio to the truth; the worst measured is 0.3 off.
TEST(EstimatedError, IsThatOfTheRung) {
  Dice dice(5);
  int trusted = 0;
  for (int k = 0; k < 600; ++k) {
    const LoadedCable c = randomLoaded(&dice, 1.0);
    const BendingExpansion effect = bendingExpansion(c.cable, c.h, c.v, c.length);
    if (!effect.trusted) continue;
    const Eigen::Vector2d truth = trueEffect(c);
    const Eigen::Vector2d first = firstOrderBending(c.cable, c.h, c.v, c.length).position;
    if (truth.norm() < 1e-11 * c.length) continue;  // rounding of the integration
    ++trusted;
    EXPECT_LT((effect.end - truth).norm(), 0.4 * truth.norm()) << "scene " << k;
    if ((truth - first).norm() < 1e-11 * c.length) continue;
    const double ratio = effect.beyond_first.norm() / (truth - first).norm();
    EXPECT_GT(ratio, 0.3) << "scene " << k;
    EXPECT_LT(ratio, 2.0) << "scene " << k;
  }
  EXPECT_GT(trusted, 250);
}

TEST(EstimatedError, IsReportedByEveryRung) {
  // A taut rope: every rung has an answer at the length of its own problem 3.
  const CableProperties rope = steelRope();
  for (int m = static_cast<int>(Model::kStraight); m <= static_cast<int>(Model::kBending); ++m) {
    const auto model = static_cast<Model>(m);
    const CableSolution s = findLength(rope, 7.0, -4.0, 300.0, 0.0, options(model));
    ASSERT_TRUE(s.status.ok()) << modelName(model) << s.status.message;
    const CableSolution truth =
        findPosition(rope, s.length, s.horizontal_force, s.vertical_force_a, options(Model::kBending, 1e-11));
    const double error = std::hypot(truth.x - s.x, truth.y - s.y);
    EXPECT_NEAR(s.estimated_error, error, 0.1 * error + 1e-9) << modelName(model);
  }
}

TEST(Auto, TakesTheCoarsestRungThatIsAccurateEnough) {
  const auto chosen = [](double accuracy) {
    CableSolverOptions asked = options(Model::kAuto);
    asked.accuracy = accuracy;
    const CableSolution s = findForces(steelRope(), 8.03, 7.0, -4.0, asked);
    EXPECT_TRUE(s.status.ok()) << s.status.message;
    EXPECT_LE(s.estimated_error, accuracy);
    return s.model;
  };
  const CableSolution catenary = findForces(steelRope(), 8.03, 7.0, -4.0, options(Model::kCatenary));
  const CableSolution corrected = findForces(steelRope(), 8.03, 7.0, -4.0, options(Model::kCatenaryCorrected));
  EXPECT_EQ(chosen(2.1 * catenary.estimated_error), Model::kCatenary);
  EXPECT_EQ(chosen(1.9 * catenary.estimated_error), Model::kCatenaryCorrected);
  EXPECT_EQ(chosen(1.9 * corrected.estimated_error), Model::kBending);

  CableSolverOptions coarse = options(Model::kAuto);
  coarse.accuracy = 0.1;
  const CableSolution taut = findLength(steelRope(), 7.0, -4.0, 1000.0, 0.0, coarse);
  EXPECT_EQ(taut.model, Model::kStraightElastic);
  EXPECT_NE(taut.status.message.find("neglects"), std::string::npos) << taut.status.message;
}

TEST(Auto, GoesToBendingWhereNoEstimateHolds) {
  const CableProperties bar = paperBar();
  CableSolverOptions asked = options(Model::kAuto);
  asked.accuracy = 0.5;
  for (const double length : {5.592, 7.0}) {
    const CableSolution s = findForces(bar, length, 5.0, -2.5, asked);
    ASSERT_TRUE(s.status.ok()) << s.status.message;
    EXPECT_EQ(s.model, Model::kBending) << length;
  }
}

TEST(Auto, KnowsThatTheCatenaryIsExactBelowTheAnchor) {
  for (const double bending_stiffness : {0.0, steelRope().bending_stiffness}) {
    CableProperties rope = steelRope();
    rope.bending_stiffness = bending_stiffness;
    CableSolverOptions asked = options(Model::kAuto);
    asked.accuracy = 1e-9;
    const CableSolution s = findForces(rope, 4.99, 0.0, -5.0, asked);
    ASSERT_TRUE(s.status.ok()) << s.status.message;
    EXPECT_LE(s.model, Model::kCatenary) << bending_stiffness;
    const CableSolution bending = findForces(rope, 4.99, 0.0, -5.0, options(Model::kBending, 1e-11));
    EXPECT_NEAR(s.vertical_force_a, bending.vertical_force_a, 1e-9 * bending.vertical_force_a);
  }
}

TEST(Auto, RefusesAnAccuracyThatIsNone) {
  for (const double bad : {0.0, -1e-3, std::numeric_limits<double>::quiet_NaN()}) {
    CableSolverOptions asked = options(Model::kAuto);
    asked.accuracy = bad;
    const CableSolution s = findForces(steelRope(), 8.1, 7.0, -4.0, asked);
    EXPECT_EQ(s.status.code, Code::kInvalidInput);
    EXPECT_NE(s.status.message.find("accuracy"), std::string::npos) << s.status.message;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

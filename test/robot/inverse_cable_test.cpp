// A cable in its pull: against the closed form of level catenaries, and against cables solved one by one.
#include "robot/inverse_cable.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cdpr_kinetostatics/cable/cable_solver.h"

namespace cdpr_kinetostatics {
namespace {

// T_A of an inextensible catenary between level ends is q a cosh(u), u = x/(2 a), least where u tanh(u) = 1. Its length
// is 2 a sinh(u), its pull H = q a.
struct LevelFold {
  LevelFold(double weight, double x) {
    double u = 1.2;
    for (int i = 0; i < 50; ++i) u = 1.0 / std::tanh(u);
    pull = 0.5 * weight * x / u;
    tension = pull * std::cosh(u);
    length = x / u * std::sinh(u);
  }
  double pull, tension, length;
};

constexpr double kWeight = 3.0;    // [N/m]
constexpr double kDistance = 4.0;  // [m]

class OneCable {
 public:
  OneCable(Model model, const Eigen::Vector3d& end, double bending_stiffness, double length) {
    description_.properties.axial_stiffness = 1e9;  // as good as inextensible
    description_.properties.bending_stiffness = bending_stiffness;
    description_.properties.weight = kWeight;
    pose_.position = end;
    cable.cable = SaggingCable(description_.properties, model, 1e-11);
    cable.lower = 0.0;
    cable.upper = 1000.0;
    EXPECT_TRUE(cable.cable.startBetween(length, end.head<2>().norm(), end.z(), {}).ok());
    EXPECT_TRUE(cable.linearise(description_, pose_, Steps::kNew, kTautInSearch));
  }

  // Often enough for a bending cable, which each call closes to second order.
  bool pullTo(double pull) {
    bool closed = true;
    for (int i = 0; i < 4; ++i) {
      closed = closed && cable.close(description_, pose_, Steps::kKept, pull, Eigen::Vector3d::Zero());
    }
    return closed;
  }

  // With the end moved, before the cable has followed.
  bool linearisedAt(const Eigen::Vector3d& end) {
    pose_.position = end;
    return cable.linearise(description_, pose_, Steps::kKept, kTautInSearch);
  }

  CableSolution solvedAt(double length) const {
    CableSolverOptions options;
    options.model = cable.cable.model();
    options.tolerance = 1e-11;
    return findForces(description_.properties, length, pose_.position.head<2>().norm(), pose_.position.z(), options);
  }

  InverseCable cable;

 private:
  CableDescription description_;
  Pose pose_;
};

TEST(InverseCable, TheLeastPullOfALevelCatenaryIsThatOfItsFold) {
  const LevelFold fold(kWeight, kDistance);
  OneCable one(Model::kCatenary, {kDistance, 0.0, 0.0}, 0.0, 1.05 * kDistance);
  ASSERT_TRUE(one.pullTo(0.0)) << "moved into the limits";
  EXPECT_TRUE(one.cable.at_fold);
  EXPECT_NEAR(one.cable.pull, fold.pull, 1e-5 * fold.pull);
  EXPECT_NEAR(one.cable.tension, fold.tension, 1e-8 * fold.tension);
  EXPECT_NEAR(one.cable.cable.length(), fold.length, 1e-5 * fold.length);
  EXPECT_NEAR(one.cable.slope, 0.0, 1e-5);
}

TEST(InverseCable, ALimitAboveTheFoldIsReachedOnTheTautSide) {
  const LevelFold fold(kWeight, kDistance);
  OneCable one(Model::kCatenary, {kDistance, 0.0, 0.0}, 0.0, 1.01 * kDistance);
  one.cable.lower = 1.1 * fold.tension;
  ASSERT_TRUE(one.pullTo(0.0));
  EXPECT_FALSE(one.cable.at_fold);
  EXPECT_NEAR(one.cable.tension, 1.1 * fold.tension, 1e-9 * fold.tension);
  EXPECT_LT(one.cable.cable.length(), fold.length);
}

TEST(InverseCable, AnUpperLimitBelowTheFoldIsSeen) {
  const LevelFold fold(kWeight, kDistance);
  OneCable one(Model::kCatenary, {kDistance, 0.0, 0.0}, 0.0, 1.05 * kDistance);
  one.cable.upper = 0.9 * fold.tension;
  ASSERT_TRUE(one.pullTo(0.0));
  EXPECT_TRUE(one.cable.too_heavy);
}

class DerivativesByPull : public testing::TestWithParam<Model> {};

// On both sides of the fold and at it, as lengths are changed.
TEST_P(DerivativesByPull, AgreeWithCablesSolvedAtOtherLengths) {
  for (const double share : {1.01, 1.1, 1.2577, 1.5}) {
    SCOPED_TRACE(share);
    const double chord = std::hypot(kDistance, 1.0);
    OneCable one(GetParam(), {kDistance, 0.0, -1.0}, 0.5, share * chord);
    ASSERT_TRUE(one.pullTo(one.cable.pull));
    const double length = one.cable.cable.length();
    const double step = 1e-5 * length;
    const CableSolution more = one.solvedAt(length + step);
    const CableSolution less = one.solvedAt(length - step);
    const double by_length = 2.0 * step / one.cable.by_pull.z();  // change of the pull
    EXPECT_NEAR((more.horizontal_force - less.horizontal_force) / by_length, one.cable.by_pull.x(), 1e-4);
    EXPECT_NEAR((more.vertical_force_a - less.vertical_force_a) / by_length, one.cable.by_pull.y(), 1e-4);
    EXPECT_NEAR((more.tension_a - less.tension_a) / by_length, one.cable.slope, 1e-4);
  }
}

// A bending cable is linearised while its end is still open: second derivatives are those of the closed one.
TEST(InverseCable, WhatIsStillOpenDoesNotBendTheCurve) {
  const double chord = std::hypot(kDistance, 1.0);
  OneCable closed(Model::kBending, {kDistance, 0.0, -1.0}, 0.5, 1.1 * chord);
  ASSERT_TRUE(closed.pullTo(closed.cable.pull));
  OneCable open(Model::kBending, {kDistance + 1e-2, 0.0, -1.0}, 0.5, 1.1 * chord);
  ASSERT_TRUE(open.linearisedAt({kDistance, 0.0, -1.0}));
  ASSERT_GT(open.cable.open, 5e-3);
  EXPECT_NEAR(open.cable.slope, closed.cable.slope, 0.05 * closed.cable.slope + 0.02);
  EXPECT_NEAR(open.cable.curvature, closed.cable.curvature, 0.1 * closed.cable.curvature);
  EXPECT_LT((open.cable.bend - closed.cable.bend).norm(), 0.1 * closed.cable.bend.norm());
}

INSTANTIATE_TEST_SUITE_P(Models, DerivativesByPull, testing::Values(Model::kCatenary, Model::kBending),
                         [](const auto& model) { return std::string(modelName(model.param)); });

}  // namespace
}  // namespace cdpr_kinetostatics

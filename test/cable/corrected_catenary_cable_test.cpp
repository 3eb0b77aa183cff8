// CATENARY_CORRECTED against closed forms and against BENDING.
#include <gtest/gtest.h>

#include <cmath>

#include "cable/corrected_catenary_cable.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"
#include "loaded_cable.h"

namespace cdpr_kinetostatics {
namespace {

CableSolverOptions options(Model model, double tolerance = 1e-8) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = tolerance;
  return result;
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

}  // namespace
}  // namespace cdpr_kinetostatics

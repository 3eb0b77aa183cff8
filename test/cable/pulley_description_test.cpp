// What a cable on a pulley says of itself: the corrected catenary against the cable that bends, and the parts of a
// whole.
#include "cable/pulley_description.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

CableSolution solved(Model model, RopeFrom from) {
  CableProperties rope = steelRope();
  rope.pulley = {0.15, from};
  rope.dead_length = 3.0;
  CableSolverOptions options;
  options.model = model;
  options.tolerance = 1e-10;
  options.profile_points = 101;
  return findPosition(rope, 9.0, 240.0, 110.0, options);
}

TEST(PulleyDescription, OfTheCorrectedCatenaryIsThatOfTheBendingCable) {
  for (const RopeFrom from : {RopeFrom::kBelow, RopeFrom::kAbove}) {
    const CableSolution bending = solved(Model::kBending, from);
    const CableSolution corrected = solved(Model::kCatenaryCorrected, from);
    ASSERT_TRUE(bending.status.ok() && corrected.status.ok()) << bending.status.message << corrected.status.message;
    EXPECT_NEAR(corrected.angle_a, bending.angle_a, 1e-5);
    EXPECT_NEAR(corrected.wrap_angle, bending.wrap_angle, 1e-5);
    EXPECT_NEAR(corrected.free_length, bending.free_length, 1e-5);
    EXPECT_NEAR(corrected.strained_length, bending.strained_length, 1e-5);
    EXPECT_NEAR(corrected.sag, bending.sag, 0.02 * bending.sag);
    EXPECT_NEAR(corrected.max_moment, bending.max_moment, 1e-6 * bending.max_moment);
    EXPECT_NEAR(corrected.max_shear, bending.max_shear, 0.05 * bending.max_shear);  // the layer is no exponential
    for (std::size_t i = 0; i < bending.profile.size(); ++i) {
      const ProfilePoint& a = corrected.profile[i];
      const ProfilePoint& b = bending.profile[i];
      EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 1e-3) << i;
      EXPECT_NEAR(a.moment, b.moment, 0.05 * bending.max_moment) << i;
    }
  }
}

TEST(PulleyDescription, AddsUpToTheWhole) {
  const CableSolution rope = solved(Model::kBending, RopeFrom::kBelow);
  ASSERT_TRUE(rope.status.ok());
  const double strain = (240.0 * std::cos(rope.angle_a) - 110.0 * std::sin(rope.angle_a)) / steelRope().axial_stiffness;
  const double dead = 3.0 - 3.0 / (1.0 + std::hypot(240.0, 110.0) / steelRope().axial_stiffness);
  EXPECT_NEAR(rope.free_length + 0.15 * rope.wrap_angle / (1.0 + strain), 9.0 + dead, 1e-9);
  EXPECT_NEAR(rope.profile.back().s, rope.free_length, 1e-12);
  EXPECT_NEAR(rope.profile.front().x, rope.departure_x, 1e-12);
  EXPECT_GE(rope.max_moment, steelRope().bending_stiffness / 0.15 * (1.0 - 1e-12));
  EXPECT_LT(rope.sag, rope.free_length);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// A hanging catenary's measures against sums along it, and what it refuses.
#include "cable/catenary_cable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

CableProperties limpRope() {
  CableProperties rope = steelRope();
  rope.bending_stiffness = 0.0;
  return rope;
}

// Sag and strained length from 4000 chords of the profile: their error is that of the midpoint rule.
TEST(CatenaryCable, MeasuresWhatItsProfileShows) {
  CatenaryCable cable(limpRope());
  const SolveOutcome outcome = cable.startBetween(9.0, 7.0, -4.0, {});
  ASSERT_TRUE(outcome.ok());
  EXPECT_GT(outcome.iterations, 0);
  EXPECT_LT(outcome.closure_residual, 1e-12);
  const CableSolution s = cable.describe(7.0, -4.0, 4001);
  EXPECT_LT(s.closure_residual, 1e-13);
  double length = 0.0, sag = 0.0;
  for (std::size_t i = 1; i < s.profile.size(); ++i) {
    const ProfilePoint& a = s.profile[i - 1];
    const ProfilePoint& b = s.profile[i];
    length += std::hypot(b.x - a.x, b.y - a.y);
    sag = std::max(sag, std::abs(b.x * -4.0 - b.y * 7.0) / std::hypot(7.0, 4.0));
    EXPECT_NEAR(b.alpha, std::atan2(b.y - a.y, b.x - a.x), 2e-3);
  }
  EXPECT_NEAR(s.strained_length, length, 1e-6);
  EXPECT_NEAR(s.sag, sag, 1e-6);
  EXPECT_NEAR(s.profile.back().x, 7.0, 1e-12);
}

TEST(CatenaryCable, RefusesWhatHasNoShapeOrPushes) {
  CableProperties weightless = limpRope();
  weightless.weight = 0.0;
  CatenaryCable light(weightless);
  EXPECT_EQ(light.startUnder(5.0, {0.0, 0.0}, {}).status.code, Code::kInvalidInput);
  EXPECT_EQ(light.startBetween(9.0, 7.0, -4.0, {}).status.code, Code::kInfeasible);
  CatenaryCable cable(limpRope());
  EXPECT_EQ(cable.startUnder(5.0, {-1.0, 2.0}, {}).status.code, Code::kInfeasible);
  CableProperties rigid = limpRope();
  rigid.axial_stiffness = kInextensible;
  CatenaryCable inextensible(rigid);
  EXPECT_EQ(inextensible.startBetween(8.0, 7.0, -4.0, {}).status.code, Code::kInfeasible);
}

}  // namespace
}  // namespace cdpr_kinetostatics

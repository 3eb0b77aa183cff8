// The rope on its guide pulley: where it leaves, what it holds of the cable, and what is refused.
#include "cable/rope_on_pulley.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cdpr_kinetostatics {
namespace {

constexpr double kStep = 1e-6;

CableProperties onPulley(RopeFrom from) { return {2e4, 0.05, 1.5, {0.07, from}, 6.0}; }

class BothSenses : public ::testing::TestWithParam<RopeFrom> {
 protected:
  CableProperties cable() const { return onPulley(GetParam()); }
  GuidePulley pulley() const { return cable().pulley; }
};

TEST_P(BothSenses, LeavesThePulleyTangentially) {
  const double r = pulley().radius;
  const Eigen::Vector2d axis(r, 0.0);
  for (const double alpha : {-1.4, -0.3, 0.0, 0.8, 1.5}) {
    const Eigen::Vector2d out = departurePoint(pulley(), alpha) - axis;
    const Eigen::Vector2d tangent(std::cos(alpha), std::sin(alpha));
    EXPECT_NEAR(out.norm(), r, 1e-15);
    EXPECT_NEAR(out.dot(tangent), 0.0, 1e-15);
    // The rope runs around the axis from A0, which lies at -r from it, in one sense.
    const double swept = std::atan2(-out.y(), -out.x());  // from the direction of A0, counterclockwise
    const double around = GetParam() == RopeFrom::kBelow ? -swept : swept;
    EXPECT_NEAR(wrapAngle(pulley(), alpha), around, 1e-12);
    const Eigen::Vector2d difference =
        (departurePoint(pulley(), alpha + kStep) - departurePoint(pulley(), alpha - kStep)) / (2.0 * kStep);
    EXPECT_LT((departureDerivative(pulley(), alpha) - difference).norm(), 1e-9 * r);
  }
}

TEST_P(BothSenses, HoldsWhatIsWrappedLessWhatTheDeadPartGives) {
  const ForcesAtA forces{300.0, -120.0};
  const double alpha = 0.5;
  const HeldRope held = heldRope(cable(), forces, alpha);
  const double along = forces.horizontal * std::cos(alpha) - forces.vertical * std::sin(alpha);
  const double wrapped = 0.07 * wrapAngle(pulley(), alpha) / (1.0 + along / 2e4);
  const double dead = 6.0 - 6.0 / (1.0 + std::hypot(300.0, 120.0) / 2e4);
  EXPECT_NEAR(held.length, wrapped - dead, 1e-15);

  const double step = 1e-3;
  const auto at = [&](double h, double v, double angle) { return heldRope(cable(), {h, v}, angle).length; };
  EXPECT_NEAR(held.by_forces.x(), (at(300.0 + step, -120.0, alpha) - at(300.0 - step, -120.0, alpha)) / (2.0 * step),
              1e-12);
  EXPECT_NEAR(held.by_forces.y(), (at(300.0, -120.0 + step, alpha) - at(300.0, -120.0 - step, alpha)) / (2.0 * step),
              1e-12);
  EXPECT_NEAR(held.by_angle, (at(300.0, -120.0, alpha + kStep) - at(300.0, -120.0, alpha - kStep)) / (2.0 * kStep),
              1e-9);
}

TEST_P(BothSenses, TheStraightLineTouchesThePulleyAndMeetsThePoint) {
  for (const double y : {-3.0, 0.01, 2.0}) {
    const double x = 1.7;
    const std::optional<TangentLine> line = tangentLine(pulley(), x, y);
    ASSERT_TRUE(line);
    const Eigen::Vector2d departure = departurePoint(pulley(), line->angle);
    const Eigen::Vector2d way = Eigen::Vector2d(x, y) - departure;
    EXPECT_NEAR(std::atan2(way.y(), way.x()), line->angle, 1e-14);
    EXPECT_NEAR(line->length, way.norm() + 0.07 * wrapAngle(pulley(), line->angle), 1e-14);
    EXPECT_TRUE(checkReach(pulley(), x, y).ok());
  }
}

INSTANTIATE_TEST_SUITE_P(RopeFrom, BothSenses, ::testing::Values(RopeFrom::kBelow, RopeFrom::kAbove));

TEST(RopeOnPulley, AnEyeletHoldsNothing) {
  CableProperties cable{2e4, 0.05, 1.5};
  EXPECT_TRUE(beginsAtEyelet(cable));
  EXPECT_EQ(heldRope(cable, {300.0, 10.0}, 0.4).length, 0.0);
  EXPECT_EQ(momentAtDeparture(cable), 0.0);
  EXPECT_EQ(departurePoint(cable.pulley, 0.4), Eigen::Vector2d::Zero());
  cable.dead_length = 1.0;
  EXPECT_FALSE(beginsAtEyelet(cable));
  EXPECT_TRUE(beginsAtEyelet(freePartOf(cable)));
}

TEST(RopeOnPulley, RefusesEndsThatItCannotReachWithASentence) {
  const GuidePulley below{0.1, RopeFrom::kBelow};
  const Status inside = checkReach(below, 0.12, 0.03);
  EXPECT_EQ(inside.code, Code::kInfeasible);
  EXPECT_NE(inside.message.find("within its guide pulley"), std::string::npos) << inside.message;
  const Status under = checkReach(below, 0.15, -2.0);  // the rope would have to come back below the pulley
  EXPECT_EQ(under.code, Code::kInfeasible);
  EXPECT_NE(under.message.find("more than half a turn"), std::string::npos) << under.message;
  EXPECT_TRUE(checkReach(below, 0.2 + 1e-9, -2.0).ok());
  EXPECT_TRUE(checkReach({0.1, RopeFrom::kAbove}, 0.15, -2.0).ok());
}

TEST(RopeOnPulley, RefusesARopeThatLiftsOff) {
  CableProperties cable{1e9, 0.5, 1.0, {0.05, RopeFrom::kBelow}};
  // The layer is sqrt(2) radii thick where the last of the pull is gone.
  const double limit = 0.5 / (2.0 * 0.05 * 0.05);
  for (const double share : {0.9, 1.1}) {
    const double slope = -0.8;
    const ForcesAtA forces{share * limit * std::cos(slope), -share * limit * std::sin(slope)};
    const double alpha = slope + 2.0 * std::asin(0.5 * std::sqrt(0.5 / forces.tension()) / 0.05);
    const Status status = checkContact(cable, forces, alpha);
    EXPECT_EQ(status.ok(), share > 1.0) << status.message;
    if (!status.ok()) {
      EXPECT_NE(status.message.find("lift off"), std::string::npos) << status.message;
    }
  }
  // Without bending stiffness: a rope from above that sags more sharply than the pulley bends it.
  cable.bending_stiffness = 0.0;
  cable.pulley.rope_from = RopeFrom::kAbove;
  EXPECT_FALSE(checkContact(cable, {0.04, 0.0}, 0.0).ok());
  EXPECT_TRUE(checkContact(cable, {0.06, 0.0}, 0.0).ok());
}

}  // namespace
}  // namespace cdpr_kinetostatics

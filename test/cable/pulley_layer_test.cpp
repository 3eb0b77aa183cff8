// The bending layer at a guide pulley: its derivatives, and what it is without weight, where an integral says so.
#include "cable/pulley_layer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cdpr_kinetostatics {
namespace {

class LayerOfBothSenses : public ::testing::TestWithParam<RopeFrom> {
 protected:
  CableProperties cable() const { return {5e4, 0.3, 2.5, {0.06, GetParam()}}; }
};

TEST_P(LayerOfBothSenses, HasTheDerivativesOfDifferences) {
  const ForcesAtA at{250.0, 140.0};
  const PulleyLayer layer = pulleyLayer(cable(), at);
  const double step = 1e-3;
  for (int axis = 0; axis < 2; ++axis) {
    const auto moved = [&](double by) {
      return pulleyLayer(cable(), {at.horizontal + (axis == 0 ? by : 0.0), at.vertical + (axis == 1 ? by : 0.0)});
    };
    const PulleyLayer more = moved(step), less = moved(-step);
    EXPECT_NEAR(layer.turn_by[axis], (more.turn - less.turn) / (2.0 * step), 1e-9 * std::abs(layer.turn));
    EXPECT_LT((layer.shift_by.col(axis) - (more.shift - less.shift) / (2.0 * step)).norm(), 1e-9 * layer.shift.norm());
  }
}

// EI alpha'' = T sin(alpha) has the first integral EI alpha'^2/2 = T (1 - cos(alpha)): with alpha' = 1/r where it
// begins the turn follows, and the shift is an integral over alpha. Simpson's rule.
TEST_P(LayerOfBothSenses, WithoutWeightIsAnElastica) {
  CableProperties rope = cable();
  rope.weight = 0.0;
  rope.axial_stiffness = std::numeric_limits<double>::infinity();
  const double tension = 220.0;
  const double sense = GetParam() == RopeFrom::kBelow ? 1.0 : -1.0;
  const double turn = std::acos(1.0 - 0.3 / (2.0 * 0.06 * 0.06 * tension));
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  constexpr int kPieces = 200;
  for (int i = 0; i <= kPieces; ++i) {
    const double alpha = turn * i / kPieces;
    const double weight = (i == 0 || i == kPieces ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * turn / kPieces / 3.0;
    const double rate = std::sqrt(2.0 * tension / 0.3 * (1.0 - std::cos(alpha)));
    if (i == 0) {
      shift.y() += weight * std::sqrt(0.3 / tension);  // sin(alpha)/rate
    } else {
      shift += weight / rate * Eigen::Vector2d(std::cos(alpha) - 1.0, std::sin(alpha));
    }
  }
  shift.y() *= sense;
  const PulleyLayer layer = pulleyLayer(rope, {tension, 0.0});
  EXPECT_NEAR(layer.turn, sense * turn, 1e-12);
  EXPECT_LT((layer.shift - shift).norm(), 1e-9 * shift.norm());
  EXPECT_NEAR(layer.shift.y(), sense * 0.3 / (0.06 * tension), 1e-12);
  EXPECT_EQ(layer.beyond.norm(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(RopeFrom, LayerOfBothSenses, ::testing::Values(RopeFrom::kBelow, RopeFrom::kAbove));

TEST(PulleyLayer, AnEyeletOrASoftRopeHasNone) {
  EXPECT_EQ(pulleyLayer({5e4, 0.3, 2.5}, {100.0, 0.0}).shift.norm(), 0.0);
  EXPECT_EQ(pulleyLayer({5e4, 0.0, 2.5, {0.1, RopeFrom::kBelow}}, {100.0, 0.0}).turn, 0.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

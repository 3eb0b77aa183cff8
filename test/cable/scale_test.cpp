// Scale invariance of one cable: in other units of length and force the three problems have the same answers in those
// units. A dimensional constant in the code would break it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "random_cables.h"
#include "scaled_robot.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kCables = 40;

// Powers of two leave every digit of products in place, though not of roots; other factors round.
const std::vector<Scale> kExact = {{1024.0, 1.0}, {1.0, 1.0 / 1024.0}, {1.0 / 1024.0, 4096.0}};
const std::vector<Scale> kRounded = {{1e-3, 1e3}, {1e3, 1e-3}, {1e3, 1e3}, {1e-3, 1e-3}};

// Largest relative difference of place, length and forces.
double differenceOf(const CableSolution& own, const Scale& scale, const CableSolution& other) {
  EXPECT_EQ(own.status.code, other.status.code) << other.status.message;
  EXPECT_EQ(own.model, other.model);
  if (!own.status.ok() || !other.status.ok()) return 0.0;
  const double apart = std::hypot(own.x - other.x / scale.length, own.y - other.y / scale.length);
  const double forces = std::hypot(own.horizontal_force - other.horizontal_force / scale.force,
                                   own.vertical_force_a - other.vertical_force_a / scale.force);
  return std::max({apart / own.length, std::abs(1.0 - other.length / scale.length / own.length),
                   forces / std::max(own.tension_a, own.tension_b)});
}

class CableScale : public testing::TestWithParam<Model> {
 protected:
  void expectTheSameInOtherUnits(const std::vector<Scale>& scales, double tolerance) const;
};

void CableScale::expectTheSameInOtherUnits(const std::vector<Scale>& scales, double tolerance) const {
  RandomCables random;
  random.least_strain = 1e-4;  // softer than rounding of the length matters
  double worst = 0.0;
  int solved = 0;
  for (int k = 0; k < kCables; ++k) {
    const CableCase c = random.next();
    if (isStraight(GetParam()) && c.length > c.chord()) continue;  // carries the least tension that there is
    CableSolverOptions options;
    options.model = GetParam();
    const CableSolution forces = findForces(c.cable, c.length, c.x, c.y, options);
    if (!forces.status.ok()) continue;
    ++solved;
    const double h = forces.horizontal_force;
    const double v = forces.vertical_force_a;
    const double tension = forces.tension_a;
    const CableSolution position = findPosition(c.cable, c.length, h, v, options);
    const CableSolution length = findLength(c.cable, c.x, c.y, tension, c.length, options);
    for (const Scale& s : scales) {
      SCOPED_TRACE(testing::Message() << c << ", lengths times " << s.length << ", forces times " << s.force);
      const CableProperties cable = scaled(s, c.cable);
      CableSolverOptions other = options;
      other.accuracy *= s.length;
      const double l = s.length * c.length;
      const double x = s.length * c.x;
      const double y = s.length * c.y;
      worst = std::max({worst, differenceOf(forces, s, findForces(cable, l, x, y, other)),
                        differenceOf(position, s, findPosition(cable, l, s.force * h, s.force * v, other)),
                        differenceOf(length, s, findLength(cable, x, y, s.force * tension, l, other))});
    }
  }
  std::cout << modelName(GetParam()) << ": " << solved << " cables, largest difference " << worst << "\n";
  EXPECT_GT(solved, 5);
  EXPECT_LE(worst, tolerance);
}

TEST_P(CableScale, PowersOfTwoChangeTheLastDigitAtMost) { expectTheSameInOtherUnits(kExact, 2e-15); }

TEST_P(CableScale, OtherFactorsChangeOnlyRounding) { expectTheSameInOtherUnits(kRounded, 1e-8); }

INSTANTIATE_TEST_SUITE_P(All, CableScale,
                         testing::Values(Model::kAuto, Model::kStraightElastic, Model::kCatenaryInextensible,
                                         Model::kCatenary, Model::kCatenaryCorrected, Model::kBendingInextensible,
                                         Model::kBending),
                         [](const testing::TestParamInfo<Model>& each) { return modelName(each.param); });

}  // namespace
}  // namespace cdpr_kinetostatics

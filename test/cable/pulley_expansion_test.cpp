// The expansion of bending at a pulley against cables that bend.
#include "cable/pulley_expansion.h"

#include <gtest/gtest.h>

#include "cable/pulley_end.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

TEST(PulleyExpansion, IsWhereTheBendingCableEnds) {
  for (const RopeFrom from : {RopeFrom::kBelow, RopeFrom::kAbove}) {
    for (const double radius : {0.08, 0.3}) {
      CableProperties rope = steelRope();
      rope.pulley = {radius, from};
      CableSolverOptions options;
      options.tolerance = 1e-11;
      const ForcesAtA forces{300.0, 100.0};
      const CableSolution bending = findPosition(rope, 9.0, forces.horizontal, forces.vertical, options);
      ASSERT_TRUE(bending.status.ok()) << bending.status.message;
      const Eigen::Vector2d catenary = pulleyEnd(rope, FreeShape::kCatenary, forces, 9.0).end.position;
      const BendingExpansion effect = pulleyExpansion(rope, forces, 9.0);
      EXPECT_TRUE(effect.trusted);
      const Eigen::Vector2d moved = Eigen::Vector2d(bending.x, bending.y) - catenary;
      EXPECT_LT((effect.end - moved).norm(), 1e-4 * moved.norm());
    }
  }
}

TEST(PulleyExpansion, IsNotTrustedWhereTheRopeLiftsOffOrIsShort) {
  CableProperties rope = steelRope();
  rope.pulley.radius = 0.02;
  EXPECT_FALSE(pulleyExpansion(rope, {100.0, 30.0}, 9.0).trusted);
  rope.pulley.radius = 0.1;
  EXPECT_TRUE(pulleyExpansion(rope, {300.0, 30.0}, 9.0).trusted);
  EXPECT_FALSE(pulleyExpansion(rope, {300.0, 30.0}, 0.4).trusted);
}

}  // namespace
}  // namespace cdpr_kinetostatics

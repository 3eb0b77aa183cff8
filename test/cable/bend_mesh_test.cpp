// The mesh of a loop that bends more sharply than its layers are long: quiet legs, a shot bend between them.
#include "cable/bend_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cable/mesh_rules.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kError = 1e-10;  // of the legs' angles [rad]

// A rope of 20 m that hangs in a narrow loop, its ends at one height, its lowest point in the middle.
ShotCable narrowLoop() {
  ShotCable cable;
  cable.properties = steelRope();
  cable.properties.bending_stiffness = 1e-3;
  cable.length = 20.0;
  cable.force = {0.02, 0.5 * cable.properties.weight * cable.length};
  cable.chooseUnits();
  return cable;
}

TEST(BendMesh, QuietLegsHaveAShotBendBetweenThem) {
  const ShotCable cable = narrowLoop();
  std::vector<MeshInterval> intervals;
  const int order = placeAroundBend(cable, kError, &intervals);
  ASSERT_GE(order, 1);
  double reached = 0.0;
  std::vector<std::size_t> quiet;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    EXPECT_EQ(intervals[i].begin, reached);
    EXPECT_LT(intervals[i].begin, intervals[i].end);
    reached = intervals[i].end;
    if (intervals[i].quiet) quiet.push_back(i);
  }
  EXPECT_EQ(reached, 1.0);
  ASSERT_EQ(quiet.size(), 2u);
  EXPECT_GT(quiet[0], 0u) << "the layers at A are shot";
  EXPECT_LT(quiet[1] + 1, intervals.size()) << "the layers at B are shot";
  const MeshInterval& before = intervals[quiet[0]];
  const MeshInterval& after = intervals[quiet[1]];
  EXPECT_LT(before.end, 0.5);
  EXPECT_GT(after.begin, 0.5);
  // The loop is symmetric but for the end forces' rounding.
  EXPECT_NEAR(before.end + after.begin, 1.0, 1e-9);
}

TEST(BendMesh, FitsTheForcesThatItWasMadeForAndNotOthers) {
  ShotCable cable = narrowLoop();
  std::vector<MeshInterval> intervals;
  const int order = placeAroundBend(cable, kError, &intervals);
  ASSERT_GE(order, 1);
  EXPECT_GE(bendOrder(intervals, cable, kError), 1);
  // The lowest point moves into a quiet leg.
  cable.force.y() *= 0.5;
  EXPECT_EQ(bendOrder(intervals, cable, kError), 0);
}

TEST(BendMesh, CablesWithoutABendOrWithoutWeightHaveNoSuchMesh) {
  ShotCable weightless = narrowLoop();
  weightless.properties.weight = 0.0;
  weightless.chooseUnits();
  ShotCable thick = narrowLoop();
  thick.properties.bending_stiffness = 1e3;  // all of it within a few layers of its ends
  thick.chooseUnits();
  for (const ShotCable& cable : {weightless, thick}) {
    std::vector<MeshInterval> intervals;
    EXPECT_EQ(placeAroundBend(cable, kError, &intervals), 0);
    EXPECT_TRUE(intervals.empty());
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

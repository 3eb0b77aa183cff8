// Where segments lie: without gaps, short enough for Newton's method, and no more of them on a longer cable whose
// middle has a closed form.
#include "cable/shooting_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cable/mesh_rules.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

// A rope of 10 m that spans this many bending layers under 1 kN.
ShotCable ropeOfLayers(double layers) {
  ShotCable cable;
  cable.properties = steelRope();
  cable.length = 10.0;
  cable.properties.bending_stiffness = 1000.0 * std::pow(cable.length / layers, 2);
  cable.force = {800.0, 600.0};
  cable.chooseUnits();
  return cable;
}

ShootingMesh placed(const ShotCable& cable, Middle middle, double tolerance = 1e-9) {
  ShootingMesh mesh;
  mesh.place(cable, ShootingAccuracy(tolerance), middle);
  return mesh;
}

int quietIntervals(const ShootingMesh& mesh) {
  int count = 0;
  for (const MeshInterval& interval : mesh.intervals()) count += interval.quiet ? 1 : 0;
  return count;
}

void expectCover(const ShootingMesh& mesh) {
  ASSERT_FALSE(mesh.intervals().empty());
  double reached = 0.0;
  for (const MeshInterval& interval : mesh.intervals()) {
    EXPECT_EQ(interval.begin, reached);
    EXPECT_LT(interval.begin, interval.end);
    reached = interval.end;
  }
  EXPECT_EQ(reached, 1.0);
}

// Layers of a shot interval of a taut cable, whose tension hardly varies.
double layersOf(const MeshInterval& interval, double layers) { return (interval.end - interval.begin) * layers; }

TEST(ShootingMesh, CoversTheCableWithoutGaps) {
  for (const double layers : {0.5, 5.0, 20.0, 100.0, 1e4}) {
    for (const Middle middle : {Middle::kQuiet, Middle::kShot}) {
      SCOPED_TRACE(layers);
      const ShotCable cable = ropeOfLayers(layers);
      const ShootingMesh mesh = placed(cable, middle);
      if (static_cast<int>(mesh.intervals().size()) > kMaxSegments) continue;  // refused by who shoots
      expectCover(mesh);
      for (const MeshInterval& interval : mesh.intervals()) {
        if (!interval.quiet) {
          EXPECT_LT(layersOf(interval, layers), 1.01 * kLayersPerSegment);
        }
      }
    }
  }
}

TEST(ShootingMesh, ALongCableHasOneQuietMiddleAndItsLengthCostsNothing) {
  const ShootingMesh shorter = placed(ropeOfLayers(100.0), Middle::kQuiet);
  const ShootingMesh longer = placed(ropeOfLayers(1e5), Middle::kQuiet);
  for (const ShootingMesh* mesh : {&shorter, &longer}) {
    EXPECT_EQ(quietIntervals(*mesh), 1);
    EXPECT_TRUE(mesh->hasQuietMiddle());
    EXPECT_FALSE(mesh->hasShotBend());
    EXPECT_GE(mesh->slowOrder(), 1);
  }
  EXPECT_LE(longer.intervals().size(), shorter.intervals().size());
  EXPECT_FALSE(placed(ropeOfLayers(100.0), Middle::kShot).hasQuietMiddle());
  EXPECT_FALSE(placed(ropeOfLayers(5.0), Middle::kQuiet).hasQuietMiddle());  // too short for a middle
}

TEST(ShootingMesh, FollowsSmallChangesOfTheForcesAndRefusesLargeOnes) {
  ShotCable cable = ropeOfLayers(200.0);
  ShootingMesh mesh = placed(cable, Middle::kQuiet);
  const ShootingAccuracy accuracy(1e-9);
  EXPECT_TRUE(mesh.fits(cable, accuracy));
  cable.force *= 1.02;
  EXPECT_TRUE(mesh.fits(cable, accuracy));
  const int order = mesh.slowOrder();
  cable.force *= 1e-3;  // layers are thirty times as long now: the modes of the ends reach far into the middle
  EXPECT_FALSE(mesh.fits(cable, accuracy));
  EXPECT_EQ(mesh.slowOrder(), order) << "a mesh that does not fit is left as it is";
  ShootingMesh shot = placed(cable, Middle::kShot);
  EXPECT_TRUE(shot.fits(cable, accuracy)) << "a mesh without quiet intervals always fits";
}

// Where stretch rules the forces the chain has several segments, however short the cable.
TEST(ShootingMesh, HasAsManyShotsAsTheAccuracyAsksFor) {
  const ShotCable cable = ropeOfLayers(0.5);
  ShootingMesh mesh;
  const ShootingAccuracy accuracy(1e-9, 1e-3);
  mesh.place(cable, accuracy, Middle::kQuiet);
  EXPECT_GE(static_cast<int>(mesh.intervals().size()), accuracy.fewestShots());
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Nodes and states of a cable in segments against integration and against the catenary.
#include "cable/segmented_cable.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cable/catenary.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

// A rope under 1 kN that is 100 bending layers long, on its catenary.
SegmentedCable ropeOnCatenary(Middle middle) {
  SegmentedCable rope;
  rope.cable.properties = steelRope();
  rope.cable.length = 10.0;
  rope.cable.properties.bending_stiffness = 1000.0 * std::pow(0.1, 2);
  rope.cable.force = {800.0, 600.0};
  rope.cable.chooseUnits();
  rope.grid_length = rope.cable.length;
  rope.mesh.place(rope.cable, ShootingAccuracy(1e-10), middle);
  rope.layOutSegments();
  rope.startOnCatenary();
  for (std::size_t k = 0; k < rope.segments.size(); ++k) {
    if (rope.segments[k].quiet) rope.evaluateQuietSegment(k);
  }
  return rope;
}

TEST(SegmentedCable, HasOneSegmentForEachIntervalOfTheMesh) {
  const SegmentedCable rope = ropeOnCatenary(Middle::kQuiet);
  ASSERT_EQ(rope.segments.size(), rope.mesh.intervals().size());
  for (std::size_t k = 0; k < rope.segments.size(); ++k) {
    EXPECT_EQ(rope.segments[k].begin, rope.mesh.intervals()[k].begin);
    EXPECT_EQ(rope.segments[k].end, rope.mesh.intervals()[k].end);
    EXPECT_EQ(rope.segments[k].quiet, rope.mesh.intervals()[k].quiet);
  }
}

TEST(SegmentedCable, StartsOnTheCatenaryWithFreeEnds) {
  const SegmentedCable rope = ropeOnCatenary(Middle::kShot);
  EXPECT_EQ(rope.segments.front().node.y(), 0.0);
  EXPECT_EQ(rope.last_node.y(), 0.0);
  const double layer = 0.1;
  for (const ShootingSegment& segment : rope.segments) {
    const double s = segment.begin * rope.cable.length;
    if (s < 10.0 * layer || s > rope.cable.length - 10.0 * layer) continue;
    const double angle = catenaryAngle(rope.cable.properties, 800.0, 600.0, s);
    EXPECT_NEAR(segment.node.x(), angle, 1e-7);  // what is left of the ends' layers: exp(-10) of 6e-5 rad
    // The curvature of the catenary, q H/T^2, times the unit of length.
    const double tension = std::hypot(800.0, 600.0 - rope.cable.properties.weight * s);
    const double curvature = rope.cable.properties.weight * 800.0 / std::pow(tension, 2);
    EXPECT_NEAR(segment.node.y(), curvature * rope.cable.unit_length, 1e-6 * rope.cable.unit_length);
  }
}

// From a state of the quiet segment, integration leads to another one, over a stretch short enough not to swell the
// growing mode.
TEST(SegmentedCable, AQuietSegmentObeysTheCablesEquations) {
  const SegmentedCable rope = ropeOnCatenary(Middle::kQuiet);
  const double span = rope.cable.span();
  int quiet = 0;
  for (const ShootingSegment& segment : rope.segments) {
    if (!segment.quiet) continue;
    ++quiet;
    const double begin = segment.begin * span;
    const double width = (segment.end - segment.begin) * span;
    for (const double share : {0.2, 0.5, 0.8}) {
      const double t = begin + share * width;
      const ShotState from = rope.quietStateAt(segment, begin, SegmentedCable::beginOf(segment), t);
      StepGrid grid;
      Shot shot;
      ASSERT_TRUE(shootAdaptive(rope.cable.parameters(), t, t + 2.0, from, 1e-12, &grid, &shot));
      const ShotState to = rope.quietStateAt(segment, t, from, t + 2.0);
      EXPECT_NEAR(shot.end.alpha, to.alpha, 1e-9);
      EXPECT_NEAR(shot.end.moment, to.moment, 1e-9);
      EXPECT_NEAR(shot.end.x, to.x, 1e-9);
      EXPECT_NEAR(shot.end.y, to.y, 1e-9);
      const Eigen::Vector2d at = rope.stateAt(t / span);
      EXPECT_NEAR(at.x(), from.alpha, 1e-12);
      EXPECT_NEAR(at.y(), from.moment, 1e-12);
    }
  }
  EXPECT_EQ(quiet, 1);
}

TEST(SegmentedCable, StatesAreThoseOfTheNodesAtTheNodesAndContinuousBetween) {
  for (const Middle middle : {Middle::kQuiet, Middle::kShot}) {
    const SegmentedCable rope = ropeOnCatenary(middle);
    for (const ShootingSegment& segment : rope.segments) {
      // A quiet segment takes the moment that goes with its node's angle, which is the node's once they are joined.
      const Eigen::Vector2d beside = rope.stateAt(segment.begin) - segment.node;
      EXPECT_LT(std::abs(beside.x()), 1e-9);
      EXPECT_LT(std::abs(beside.y()), segment.quiet ? 1e-6 : 1e-9);
      const double inside = segment.begin + 1e-9;
      EXPECT_LT((rope.stateAt(inside) - rope.stateAt(segment.begin)).norm(), 1e-6);
    }
    EXPECT_LT((rope.stateAt(1.0) - rope.last_node).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

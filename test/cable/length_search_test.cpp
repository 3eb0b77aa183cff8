// The search along T_A(L) on curves whose roots are known, and the lengths that need no search.
#include "cable/length_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cdpr_kinetostatics {
namespace {

// Falls from infinity at length 1 to the least tension at 2, and rises again: T = 1/(L - 1) + (L - 1).
std::optional<TensionSample> valley(double length) {
  const double d = length - 1.0;
  return TensionSample{length, 1.0 / d + d, 1.0 - 1.0 / (d * d)};
}

LengthSearch searchFor(double tension, double hint = 0.0) {
  LengthSearch search;
  search.tension = tension;
  search.chord = 1.0;
  search.shortest = 1.01;
  search.longest = 20.0;
  search.hint = hint;
  return search;
}

// Roots of d^2 - T d + 1 = 0.
double shorter(double tension) { return 1.0 + 0.5 * (tension - std::sqrt(tension * tension - 4.0)); }
double longer(double tension) { return 1.0 + 0.5 * (tension + std::sqrt(tension * tension - 4.0)); }

TEST(LengthSearch, FindsTheShortestLengthAndTheOneNearestToAHint) {
  for (const double tension : {2.001, 2.5, 10.0}) {
    const LengthFound shortest = searchLength(valley, searchFor(tension));
    ASSERT_TRUE(shortest.length);
    EXPECT_NEAR(*shortest.length, shorter(tension), 1e-7);
    const LengthFound hinted = searchLength(valley, searchFor(tension, 1.1 * longer(tension)));
    ASSERT_TRUE(hinted.length);
    EXPECT_NEAR(*hinted.length, longer(tension), 1e-7);
  }
}

TEST(LengthSearch, ReportsTheLeastTensionWhereThereIsNoLength) {
  const LengthFound found = searchLength(valley, searchFor(1.9));
  EXPECT_FALSE(found.length);
  EXPECT_TRUE(found.complete);
  EXPECT_NEAR(found.least_tension, 2.0, 1e-9);
}

TEST(LengthSearch, SaysWhereTheCurveEnds) {
  const auto torn = [](double length) { return length < 1.5 ? valley(length) : std::nullopt; };
  const LengthFound found = searchLength(torn, searchFor(2.1));
  EXPECT_FALSE(found.length);
  EXPECT_FALSE(found.complete);
}

TEST(LengthSearch, NewtonFromAHintFindsItsRootOrGivesUp) {
  const std::optional<double> root = rootNearHint(valley, searchFor(10.0, 1.1));
  ASSERT_TRUE(root);
  EXPECT_NEAR(*root, shorter(10.0), 1e-9);
  EXPECT_FALSE(rootNearHint(valley, searchFor(1.0, 1.9)));
}

// The sag of a string of weight q x under T is q x^2/(8 T): below rounding here, visible there.
TEST(AString, IsAnInextensibleCableWhoseSagIsBelowRounding) {
  const CableProperties rope{std::numeric_limits<double>::infinity(), 0.0, 1.0};
  EXPECT_TRUE(isString(rope, 1.0, 0.0, 1e6, 0.0));
  EXPECT_FALSE(isString(rope, 1.0, 0.0, 1e3, 0.0));
  EXPECT_FALSE(isString(rope, 1.0, 0.0, 1e6, 1.5)) << "a hint asks for a loop";
  EXPECT_TRUE(isString(rope, 0.0, -3.0, 3.5, 0.0));
  EXPECT_FALSE(isString(rope, 0.0, -3.0, 2.5, 0.0)) << "less than the rope's own weight";
  CableProperties elastic = rope;
  elastic.axial_stiffness = 1e9;
  EXPECT_FALSE(isString(elastic, 1.0, 0.0, 1e6, 0.0));
}

// T_A of a loop of length L, both ends at one height, is at least its share of the weight, q L/2.
TEST(LongestSagging, IsBeyondEveryLengthThatTheTensionCanHold) {
  const double weight = 2.0, chord = 3.0;
  for (const double tension : {5.0, 50.0}) {
    EXPECT_GT(longestSagging(weight, chord, tension), 2.0 * tension / weight);
  }
  EXPECT_GT(longestSagging(0.0, chord, 1.0), chord);
}

}  // namespace
}  // namespace cdpr_kinetostatics

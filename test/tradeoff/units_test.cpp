#include "tradeoff/units.h"

#include <gtest/gtest.h>

namespace cdpr_kinetostatics {
namespace {

TEST(Units, LengthsHaveThreeDigits) {
  EXPECT_EQ(asLength(0.0), "0 m");
  EXPECT_EQ(asLength(1.2345), "1.23 m");
  EXPECT_EQ(asLength(0.0123456), "12.3 mm");
  EXPECT_EQ(asLength(3.14159e-7), "314 nm");
}

TEST(Units, TimesHaveTwoDigits) {
  EXPECT_EQ(asTime(2.345e-3), "2.3 ms");
  EXPECT_EQ(asTime(1.2e-6), "1.2 us");
  EXPECT_EQ(asTime(0.25), "250 ms");
}

TEST(Units, WhatRoundsUpToAThousandTakesTheNextPrefix) {
  EXPECT_EQ(asLength(0.9996e-3), "1 mm");
  EXPECT_EQ(asLength(0.9994e-3), "999 um");
}

TEST(Units, SmallestAreNotShownAsZero) {
  EXPECT_EQ(asLength(2e-13), "0.2 pm");
  EXPECT_EQ(asLength(1e-14), "<0.1 pm");
}

}  // namespace
}  // namespace cdpr_kinetostatics

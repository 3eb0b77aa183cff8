#include "robot/angle_expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace cdpr_kinetostatics {
namespace {

TEST(AngleExpression, DegreesAreDecimals) {
  EXPECT_EQ(degreesToRadians("180"), M_PI);
  EXPECT_EQ(degreesToRadians(" -4.5e1 "), -M_PI / 4.0);
  for (const char* text : {"", "  ", "x", "90 deg", "pi", "1/2"})
    EXPECT_EQ(degreesToRadians(text), std::nullopt) << text;
}

TEST(AngleExpression, RadiansAreArithmetic) {
  EXPECT_EQ(evaluateRadians("pi"), M_PI);
  EXPECT_EQ(evaluateRadians("2*pi/3"), 2.0 * M_PI / 3.0);
  EXPECT_EQ(evaluateRadians("1-2-3"), -4.0);
  EXPECT_EQ(evaluateRadians("8/4/2"), 1.0);
  EXPECT_EQ(evaluateRadians("2-3*4"), -10.0);
  EXPECT_EQ(evaluateRadians("-(1.5 + -2e-1) * +2"), -2.6);
  EXPECT_EQ(evaluateRadians("1e+1+1"), 11.0);
}

TEST(AngleExpression, WhatIsNotUnderstoodIsNotGuessed) {
  for (const char* text : {"",     "(",    ")",       "1)",      "(1",  "1 2", "2 pi", "2pi", "pi pi", "1+",  "*1",
                           "1**2", "1//2", "sqrt(2)", "math.pi", "010", "1_0", "0x10", "e",   "1e",    "1e+", "pi;1"}) {
    EXPECT_EQ(evaluateRadians(text), std::nullopt) << text;
  }
}

TEST(AngleExpression, NestingHasAnEnd) {
  EXPECT_EQ(evaluateRadians(std::string(1000000, '(')), std::nullopt);
  EXPECT_EQ(evaluateRadians(std::string(1000000, '-')), std::nullopt);
  EXPECT_EQ(evaluateRadians("((((-(-((2)))))))"), 2.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

#include "robot/yaml_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace cdpr_kinetostatics {
namespace {

TEST(YamlNumber, WholeNumbersHaveFiveBases) {
  EXPECT_EQ(readWholeNumber("1_000"), 1000.0);
  EXPECT_EQ(readWholeNumber("-010"), -8.0);
  EXPECT_EQ(readWholeNumber("0xfF"), 255.0);
  EXPECT_EQ(readWholeNumber("0b1_01"), 5.0);
  EXPECT_EQ(readWholeNumber("1:30:01"), 5401.0);
  EXPECT_TRUE(std::isnan(readWholeNumber("-0x_").value()));
  for (const char* text : {"", "-", "08", "0x", "1.0", "1e3", " 1", "1 ", "0:30"}) {
    EXPECT_EQ(readWholeNumber(text), std::nullopt) << text;
  }
}

TEST(YamlNumber, PointsDivide) {
  EXPECT_EQ(readPointNumber("1_0.5"), 10.5);
  EXPECT_EQ(readPointNumber("010.5"), 10.5);
  EXPECT_EQ(readPointNumber("1:30.5"), 90.5);
  EXPECT_EQ(readPointNumber("-.INF"), -HUGE_VAL);
  EXPECT_TRUE(std::isnan(readPointNumber(".nan").value()));
  EXPECT_EQ(readPointNumber("1.0e+400"), HUGE_VAL);
  for (const char* text : {"", ".", "1", "1.0e3", "-.5", "inf"}) EXPECT_EQ(readPointNumber(text), std::nullopt) << text;
}

TEST(YamlNumber, DecimalsHaveOneMeaning) {
  EXPECT_EQ(readDecimal("1e3"), 1000.0);
  EXPECT_EQ(readDecimal("-.5E-1"), -0.05);
  EXPECT_EQ(readDecimal("0.5"), 0.5);
  EXPECT_EQ(readDecimal("010"), std::nullopt);
  EXPECT_EQ(readDecimal("-010.5"), std::nullopt);
  EXPECT_EQ(readPythonFloat("010"), 10.0);
  for (const char* text : {"", ".", "e3", "1e", "inf", "nan", "0x10", "1_0", "+-1"}) {
    EXPECT_EQ(readDecimal(text), std::nullopt) << text;
    EXPECT_EQ(readPythonFloat(text), std::nullopt) << text;
  }
}

TEST(YamlNumber, DigitsComeBack) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const double value = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 200) - 100);
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.17e", value);
    EXPECT_EQ(readPointNumber(digits), value) << digits;
    EXPECT_EQ(readDecimal(digits), value) << digits;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

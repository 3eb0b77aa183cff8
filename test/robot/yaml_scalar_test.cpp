// Each scalar means what roslaunch makes of it: the table is computed by roslaunch's own reader.

#include "robot/yaml_scalar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "yaml_readings.h"

namespace cdpr_kinetostatics {
namespace {

using Kind = YamlScalar::Kind;

YamlScalar scalarOf(const std::string& yaml) { return readScalar(YAML::Load("a: " + yaml)["a"]); }

// As the table calls it.
std::string kindOf(const std::string& text) {
  try {
    const YAML::Node node = YAML::Load("a: " + text)["a"];
    if (node.IsMap()) return "map";
    if (node.IsSequence()) return "list";
    switch (readScalar(node).kind) {
      case Kind::kNothing:
        return "nothing";
      case Kind::kFlag:
        return "flag";
      case Kind::kWholeNumber:
        return "whole";
      case Kind::kNumber:
        return "number";
      case Kind::kText:
        return "text";
      case Kind::kRefused:
        return "refused";
    }
  } catch (const YAML::Exception&) {
  }
  return "refused";
}

double tableNumber(const YAML::Node& value) {
  const std::string digits = value.as<std::string>();
  return std::strtod(digits.c_str(), nullptr);
}

TEST(YamlScalar, MeansWhatRoslaunchMakesOfIt) {
  int rows = 0;
  for (const YamlReading& row : yamlReadings("scalars")) {
    SCOPED_TRACE(row.text);
    ++rows;
    // What roslaunch refuses for its size alone has one meaning.
    if (row.kind == "refused" && kindOf(row.text) == "number") {
      EXPECT_GE(std::abs(scalarOf(row.text).number), 2147483648.0);
      continue;
    }
    ASSERT_EQ(kindOf(row.text), row.kind);
    if (row.kind == "map" || row.kind == "list" || row.kind == "refused") continue;
    const YamlScalar scalar = scalarOf(row.text);
    if (row.kind == "flag") {
      EXPECT_EQ(scalar.flag, row.value.as<bool>());
    } else if (row.kind == "text") {
      EXPECT_EQ(scalar.text, row.value.as<std::string>());
    } else if (row.kind != "nothing") {
      const double expected = tableNumber(row.value);
      EXPECT_TRUE(scalar.number == expected || (std::isnan(scalar.number) && std::isnan(expected))) << scalar.number;
      EXPECT_EQ(std::signbit(scalar.number), std::signbit(expected));
    }
  }
  EXPECT_GT(rows, 150);
}

TEST(YamlScalar, TextsThatAreDecimalNumbersAreNumbers) {
  EXPECT_EQ(numberOf(scalarOf("2.87e5")), 2.87e5);
  EXPECT_EQ(numberOf(scalarOf("-.5")), -0.5);
  EXPECT_EQ(numberOf(scalarOf("'10'")), 10.0);
  EXPECT_EQ(numberOf(scalarOf("010")), 8.0);
  for (const char* text : {"'010'", "08", "5 kg", "1:60", "0:30", "inf", "nan", "0x", "''", "true", "~", "'0x10'"}) {
    EXPECT_EQ(numberOf(scalarOf(text)), std::nullopt) << text;
  }
}

TEST(YamlScalar, WordsAreTextsAndWholeNumbers) {
  EXPECT_EQ(wordOf(scalarOf("north")), "north");
  EXPECT_EQ(wordOf(scalarOf("'yes'")), "yes");
  EXPECT_EQ(wordOf(scalarOf("7")), "7");
  EXPECT_EQ(wordOf(scalarOf("010")), "8") << "what the node sees";
  for (const char* text : {"yes", "1.0", "~", "deg(10)"}) EXPECT_EQ(wordOf(scalarOf(text)), std::nullopt) << text;
}

TEST(YamlScalar, NodesThatProgramsMakeAreReadToo) {
  EXPECT_EQ(numberOf(readScalar(YAML::Node(2.5))), 2.5);
  EXPECT_EQ(numberOf(readScalar(YAML::Node(7))), 7.0);
  EXPECT_EQ(readScalar(YAML::Node(true)).kind, Kind::kFlag);
  EXPECT_EQ(readScalar(YAML::Node()).kind, Kind::kNothing);
}

// roslaunch refuses them: there is no other meaning.
TEST(YamlScalar, WholeNumbersMayBeLargerThanThoseOfRos) {
  EXPECT_EQ(numberOf(scalarOf("2147483648")), 2147483648.0);
  EXPECT_EQ(numberOf(scalarOf("200000000000")), 2e11);
}

TEST(YamlScalar, RefusalsSayWhatIsExpected) {
  EXPECT_NE(scalarOf("rad(tau)").text.find("numbers and pi"), std::string::npos);
  EXPECT_NE(scalarOf("!foo 1").text.find("!degrees"), std::string::npos);
}

TEST(YamlScalar, TextsOfAnyLengthAreTexts) {
  const std::string ones(1000000, '1');
  EXPECT_EQ(scalarOf(ones).kind, Kind::kText);
  EXPECT_EQ(numberOf(scalarOf("'" + ones + "'")), std::nullopt);
  EXPECT_EQ(scalarOf("rad(" + std::string(1000000, '-') + "1)").kind, Kind::kRefused);
  EXPECT_LT(quote(YAML::Node(ones)).size(), 100U);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// A document holds what roslaunch would hand to the parameter server: the table is computed by roslaunch's own reader.

#include "robot/yaml_tree.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "robot/yaml_file.h"
#include "robot/yaml_scalar.h"
#include "yaml_readings.h"

namespace cdpr_kinetostatics {
namespace {

// The plain tree, or what is said against the document.
std::string refusalOf(const std::string& yaml) {
  try {
    plainTree(YAML::Load(yaml));
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

void expectSame(const YAML::Node& found, const YAML::Node& expected) {
  ASSERT_EQ(found.Type(), expected.Type());
  ASSERT_EQ(found.size(), expected.size());
  if (expected.IsMap()) {
    for (const auto& entry : expected) {
      const auto key = entry.first.as<std::string>();
      SCOPED_TRACE(key);
      ASSERT_TRUE(found[key].IsDefined());
      expectSame(found[key], entry.second);
    }
  } else if (expected.IsSequence()) {
    for (std::size_t i = 0; i < expected.size(); ++i) expectSame(found[i], expected[i]);
  } else {
    const YamlScalar scalar = readScalar(found);
    EXPECT_EQ(wordOf(scalar), expected.as<std::string>());
  }
}

TEST(YamlTree, IsWhatRoslaunchMakesOfTheDocument) {
  int rows = 0;
  for (const YamlReading& row : yamlReadings("documents")) {
    SCOPED_TRACE(row.text);
    ++rows;
    try {
      const YAML::Node tree = plainTree(loadDocument(row.text));
      ASSERT_EQ(row.kind, "map");
      expectSame(tree, row.value);
    } catch (const YAML::Exception&) {
      EXPECT_EQ(row.kind, "refused");
    } catch (const std::invalid_argument&) {
      EXPECT_EQ(row.kind, "refused");
    }
  }
  EXPECT_GT(rows, 35);
}

TEST(YamlTree, RefusalsSayWhere) {
  EXPECT_EQ(refusalOf("{a: [{b: 1, b: 2}]}"), "a[0].b is given twice: expected each key once");
  EXPECT_EQ(refusalOf("{<<: {a: 1}, <<: {b: 2}}"), "<< is given twice: expected one list of what is merged");
  EXPECT_EQ(refusalOf("{a: {b: [1, !foo 2]}}").substr(0, 17), "a.b[1] = !<!foo> ");
  EXPECT_EQ(refusalOf("{a: {b: ~}}"), "a.b = nothing: expected a value, or no such key");
  EXPECT_EQ(refusalOf("{a/b: 1}"), "robot has the key a/b: expected names as keys, without / and ~");
  EXPECT_EQ(refusalOf("{a: {1: 2}}"), "a has the key 1: expected names as keys, without / and ~");
  EXPECT_EQ(refusalOf("{a: !foo {b: 1}}"), "a has the tag !foo: expected no tag");
  EXPECT_EQ(refusalOf("{a: {<<: 5}}"), "a.<< = 5: expected a map to merge");
}

TEST(YamlTree, HasAnEnd) {
  EXPECT_NE(refusalOf("&a [*a]").find("expected fewer"), std::string::npos);
  EXPECT_NE(refusalOf("&a {b: *a}").find("expected fewer"), std::string::npos);
  EXPECT_NE(refusalOf("&a {<<: *a}"), "");
  EXPECT_NE(refusalOf("{a: &a {<<: [*a]}}"), "");
  // Each level holds the one below ten times.
  std::string bomb = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string below = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 10; ++k) bomb += below + (k < 9 ? ", " : "]\n");
  }
  EXPECT_NE(refusalOf(bomb).find("more than 100000 values"), std::string::npos);
}

}  // namespace
}  // namespace cdpr_kinetostatics

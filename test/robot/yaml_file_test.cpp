#include "robot/yaml_file.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace cdpr_kinetostatics {
namespace {

TEST(YamlFile, HasOneDocument) {
  EXPECT_EQ(loadDocument("a: 1")["a"].as<int>(), 1);
  EXPECT_EQ(loadDocument("---\na: 1\n...\n# the end\n")["a"].as<int>(), 1);
  EXPECT_TRUE(loadDocument("").IsNull());
  EXPECT_TRUE(loadDocument("# nothing\n").IsNull());
}

TEST(YamlFile, NothingFollowsTheDocument) {
  for (const char* text : {"a: 1\n---\nb: 2", "a: 1\n---\n", "{a: 1} {b: 2}", ",a: 1", "[1] ]", "a: 1\n...\nb: 2"}) {
    try {
      loadDocument(text);
      ADD_FAILURE() << text << " was read";
    } catch (const std::invalid_argument&) {
    } catch (const YAML::Exception&) {
    }
  }
}

TEST(YamlFile, MustBeReadable) {
  EXPECT_THROW(loadYamlFile("/nowhere/robot.yaml"), std::invalid_argument);
  EXPECT_THROW(loadYamlFile(ROBOT_DIR), std::invalid_argument);
  EXPECT_EQ(loadYamlFile(ROBOT_DIR "/cogiro.yaml")["name"].as<std::string>(), "cogiro");
}

}  // namespace
}  // namespace cdpr_kinetostatics

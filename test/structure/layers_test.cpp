// Data flows one way (docs/architecture.md). Each folder of src/ and include/ includes only what it stands on, and only
// those on top of ROS include ROS. A folder that is not in the list fails, so that a new one is placed on purpose.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

struct Layer {
  std::set<std::string> stands_on;  // itself is allowed anyway
  bool uses_ros = false;
};

const std::map<std::string, Layer> kLayers = {
    {"cable", {{}}},
    {"geometry", {{}}},
    {"residuals", {{"cable", "geometry"}}},
    {"robot", {{"cable", "geometry", "residuals"}}},
    {"estimation", {{"cable", "geometry", "residuals", "robot"}}},
    {"timing", {{}}},
    {"tradeoff", {{"cable", "geometry", "robot", "estimation", "timing"}}},
    {"ros", {{"cable", "geometry", "robot", "estimation"}, true}},
    {"rig", {{"cable", "geometry", "robot", "estimation", "ros"}, true}},
};

bool isRos(const std::string& included) {
  static const std::regex kRos(R"re(^(ros|xmlrpcpp|tf2|tf2_ros|interactive_markers|diagnostic_updater)/.*)re");
  static const std::regex kMessage(R"re(^[a-z0-9_]+_(msgs|srvs)/.*)re");
  static const std::regex kOurMessage(R"re(^cdpr_kinetostatics/[A-Z].*)re");
  return std::regex_match(included, kRos) || std::regex_match(included, kMessage) ||
         std::regex_match(included, kOurMessage);
}

void checkFile(const fs::path& file, const std::string& name, const Layer& layer) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  static const std::regex kOurs(R"re(^(?:cdpr_kinetostatics/)?([a-z]+)/.*)re");
  std::ifstream stream(file);
  std::smatch match;
  for (std::string line; std::getline(stream, line);) {
    if (!std::regex_search(line, match, kInclude)) continue;
    const std::string included = match[1];
    if (!layer.uses_ros) {
      EXPECT_FALSE(isRos(included)) << file << " includes " << included << " of ROS";
    }
    if (!std::regex_match(included, match, kOurs) || kLayers.count(match[1]) == 0) continue;
    if (included.rfind("ros/", 0) == 0 && !fs::exists(SOURCE_DIR "/src/" + included)) continue;  // of roscpp
    const std::string other = match[1];
    EXPECT_TRUE(other == name || layer.stands_on.count(other) > 0) << file << " includes " << included;
  }
}

TEST(Layers, EachIncludesOnlyWhatItStandsOn) {
  int files = 0;
  for (const std::string root : {SOURCE_DIR "/include/cdpr_kinetostatics/", SOURCE_DIR "/src/"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (!entry.is_regular_file()) continue;
      const std::string name = fs::relative(entry.path(), root).begin()->string();
      const auto layer = kLayers.find(name);
      if (layer == kLayers.end()) {
        ADD_FAILURE() << entry.path() << ": the layer '" << name << "' is not in this test's list";
        continue;
      }
      checkFile(entry.path(), name, layer->second);
      ++files;
    }
  }
  EXPECT_GT(files, 100);
}

TEST(Layers, StandOnEachOtherInOneOrder) {
  // A layer's foundations are complete: whatever they stand on is in its own list, too, so there is no circle.
  for (const auto& [name, layer] : kLayers) {
    EXPECT_EQ(layer.stands_on.count(name), 0U) << name;
    for (const std::string& below : layer.stands_on) {
      ASSERT_EQ(kLayers.count(below), 1U) << below;
      EXPECT_EQ(kLayers.at(below).stands_on.count(name), 0U) << name << " and " << below;
      EXPECT_TRUE(layer.uses_ros || !kLayers.at(below).uses_ros) << name << " has no ROS, but " << below << " has";
    }
  }
}

}  // namespace

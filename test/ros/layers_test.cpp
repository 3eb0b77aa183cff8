// Data flows one way: cable <- residuals <- robot <- estimation <- ros. Each layer includes only those before it, and
// none but the last includes ROS.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"cable", {"cable"}},
    {"residuals", {"cable", "residuals"}},
    {"robot", {"cable", "residuals", "robot"}},
    {"estimation", {"cable", "residuals", "robot", "estimation"}},
};

void checkFile(const fs::path& file, const std::set<std::string>& allowed) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  static const std::regex kRos(R"re(^(ros|xmlrpcpp|tf2|tf2_ros)/.*|^[a-z0-9_]+_(msgs|srvs)/.*)re");
  static const std::regex kOurs(R"re(^cdpr_kinetostatics/([a-z]+)/.*)re");
  std::ifstream stream(file);
  std::smatch match;
  for (std::string line; std::getline(stream, line);) {
    if (!std::regex_search(line, match, kInclude)) continue;
    const std::string included = match[1];
    EXPECT_FALSE(std::regex_match(included, kRos)) << file << " includes " << included;
    const bool generated = included.rfind("cdpr_kinetostatics/", 0) == 0 && !std::regex_match(included, kOurs);
    EXPECT_FALSE(generated) << file << " includes the message " << included;
    if (std::regex_match(included, match, kOurs)) {
      EXPECT_TRUE(allowed.count(match[1])) << file << " includes " << included;
    }
  }
}

TEST(Layers, EachIncludesOnlyThoseBeforeIt) {
  int files = 0;
  for (const auto& [layer, allowed] : kMayInclude) {
    for (const std::string root : {SOURCE_DIR "/include/cdpr_kinetostatics/", SOURCE_DIR "/src/"}) {
      if (!fs::exists(root + layer)) continue;
      for (const auto& entry : fs::recursive_directory_iterator(root + layer)) {
        if (!entry.is_regular_file()) continue;
        checkFile(entry.path(), allowed);
        ++files;
      }
    }
  }
  EXPECT_GT(files, 10);
}

}  // namespace

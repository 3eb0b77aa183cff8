// What is installed stands on its own: a public header includes public headers only. That each compiles alone, with
// nothing but include/ on its path, is what this test's build does (public_headers_alone in cmake/tests.cmake).

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

namespace {

namespace fs = std::filesystem;

TEST(PublicHeaders, IncludeNoInternalOnes) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*"([^"]+)")re");
  const std::string root = SOURCE_DIR "/include/";
  int headers = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (!entry.is_regular_file()) continue;
    ++headers;
    std::ifstream file(entry.path());
    std::smatch match;
    for (std::string line; std::getline(file, line);) {
      if (!std::regex_search(line, match, kInclude)) continue;
      EXPECT_TRUE(fs::exists(root + match[1].str())) << entry.path() << " includes " << match[1];
    }
  }
  EXPECT_GT(headers, 10);
}

}  // namespace

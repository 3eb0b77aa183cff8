// Tests carry the names of what they test: src/<layer>/<name>.cpp of the core has test/<layer>/<name>_test.cpp, so that
// who changes the one finds the other. The exceptions are below, each with its reason.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

namespace {

namespace fs = std::filesystem;

// Source, and where its logic is tested instead, or why there is nothing to test.
const std::map<std::string, std::string> kExceptions = {
    {"robot/attitude_program.cpp", "tension_program_test, attitude_search_test"},
    {"robot/basin_search.cpp", "far_seeds_test"},
    {"robot/forward_path.cpp", "forward_follower_test, forward_solve_test"},
    {"robot/forward.cpp", "round_trip_test, far_seeds_test, refusal_test"},
    {"robot/inverse_iteration.cpp", "inverse_solve_test, inverse_test"},
    {"robot/residual_blocks.cpp", "far_seeds_test"},
    {"robot/robot_solution.cpp", "two loops that copy a number per cable"},
};

fs::path testOf(const std::string& source) {
  const fs::path path(source);
  return fs::path(SOURCE_DIR) / "test" / path.parent_path() / (path.stem().string() + "_test.cpp");
}

TEST(TestNames, EachSourceOfTheCoreHasItsTest) {
  int sources = 0;
  for (const std::string layer : {"cable", "geometry", "residuals", "robot", "estimation"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_DIR) / "src" / layer)) {
      if (entry.path().extension() != ".cpp") continue;
      ++sources;
      const std::string source = layer + "/" + entry.path().filename().string();
      if (kExceptions.count(source) > 0) continue;
      EXPECT_TRUE(fs::exists(testOf(source))) << source << " has no test of its name";
    }
  }
  EXPECT_GT(sources, 40);
}

TEST(TestNames, ExceptionsAreStillNeeded) {
  for (const auto& [source, reason] : kExceptions) {
    EXPECT_TRUE(fs::exists(fs::path(SOURCE_DIR) / "src" / source)) << source << " is no source any more";
    EXPECT_FALSE(fs::exists(testOf(source))) << source << " has a test of its name now";
    EXPECT_FALSE(reason.empty()) << source;
  }
}

}  // namespace

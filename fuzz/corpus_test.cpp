// A fuzz target in a build like any other: over its committed corpus, and over inputs drawn by dice that always fall
// alike. A violation of an invariant ends the program.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

// Seconds of work for the slowest target, the estimator.
constexpr int kInputs = 300;
constexpr std::size_t kLongest = 1024;  // [bytes]

TEST(FuzzTarget, AnswersItsCorpus) {
  if (!std::filesystem::exists(CORPUS)) GTEST_SKIP() << "nothing was committed for this target";
  for (const auto& entry : std::filesystem::directory_iterator(CORPUS)) {
    SCOPED_TRACE(entry.path());
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), 0);
  }
}

TEST(FuzzTarget, AnswersAnything) {
  std::mt19937 random(1);
  for (int i = 0; i < kInputs; ++i) {
    std::vector<std::uint8_t> bytes(random() % kLongest);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    EXPECT_EQ(LLVMFuzzerTestOneInput(bytes.data(), bytes.size()), 0) << "input " << i;
  }
}

}  // namespace

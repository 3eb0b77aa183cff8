#include "tradeoff/provenance.h"

#include <fstream>
#include <thread>

#include "tradeoff_build.h"

namespace cdpr_kinetostatics {
namespace {

std::string cpuModel() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

Provenance provenance() {
#ifdef __clang__
  const std::string compiler = "Clang " __clang_version__;
#else
  const std::string compiler = "GCC " __VERSION__;
#endif
  return {cpuModel(), std::thread::hardware_concurrency(), compiler, kBuildType, kCommit};
}

}  // namespace cdpr_kinetostatics

#include "tradeoff/shipped_robots.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "tradeoff_build.h"

namespace cdpr_kinetostatics {

std::vector<std::string> shippedRobots() {
  namespace fs = std::filesystem;
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path prefix =
      program.parent_path().parent_path().parent_path();  // <prefix>/lib/cdpr_kinetostatics/tradeoff
  std::vector<std::string> files;
  for (const fs::path& directory : {prefix / "share/cdpr_kinetostatics/config/robots", fs::path(kSourceRobots)}) {
    if (!files.empty() || !fs::is_directory(directory)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
      if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
    }
  }
  if (files.empty()) throw std::runtime_error("no robots were found beside the program; name one with --robot FILE");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace cdpr_kinetostatics

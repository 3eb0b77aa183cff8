// Where the numbers come from: times mean little without it.
#pragma once

#include <string>

namespace cdpr_kinetostatics {

struct Provenance {
  std::string cpu;
  unsigned cores = 0;
  std::string compiler;
  std::string build_type;
  std::string commit;
};

Provenance provenance();

}  // namespace cdpr_kinetostatics

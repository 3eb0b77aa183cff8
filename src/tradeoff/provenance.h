// The machine, compiler and commit that the numbers come from; times mean little without them.
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

// The robot descriptions that come with the package.
#pragma once

#include <string>
#include <vector>

namespace cdpr_kinetostatics {

// Their files, sorted; from where the package was installed, or else from its sources. Throws std::runtime_error if
// there are none.
std::vector<std::string> shippedRobots();

}  // namespace cdpr_kinetostatics

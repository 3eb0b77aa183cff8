#include "robot/tension_limits.h"

#include <sstream>

namespace cdpr_kinetostatics {

Status contradiction(const RobotDescription& robot, const std::vector<InverseCable>& cables,
                     const TensionDistribution& distribution) {
  std::ostringstream limits;
  const char* separator = "";
  const auto name = [&](std::size_t i, const char* limit, double tension) {
    limits << separator << "'" << robot.cables[i].name << "' " << limit << " " << tension << " N";
    separator = ", ";
  };
  const char* const least = "least tension that can hold the cable";
  for (std::size_t i = 0; i < cables.size(); ++i) {
    if (!cables[i].too_heavy) continue;
    name(i, least, cables[i].tension);
    name(i, "tension_max", cables[i].upper);
  }
  if (limits.str().empty()) {
    for (const int i : distribution.at_lower) {
      name(i, cables[i].at_fold ? least : "tension_min", cables[i].at_fold ? cables[i].tension : cables[i].lower);
    }
    for (const int i : distribution.at_upper) name(i, "tension_max", cables[i].upper);
  }
  std::string text = "no tensions within the limits balance the load at this pose";
  if (!limits.str().empty()) text += "; these limits cannot all be met: " + limits.str();
  return {Code::kInfeasible, text};
}

}  // namespace cdpr_kinetostatics

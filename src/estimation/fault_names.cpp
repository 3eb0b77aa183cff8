#include "estimation/fault_names.h"

namespace cdpr_kinetostatics {

std::vector<std::string> faultNames(const RobotSolution& solution, const std::vector<bool>& lengths,
                                    const std::vector<bool>& tensions, const Eigen::Array<bool, 6, 1>& load) {
  static const char* const kComponents[] = {"force x", "force y", "force z", "torque x", "torque y", "torque z"};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const std::string& cable = solution.cables[i].name;
    if (lengths[i]) names.push_back("length of " + cable);
    if (tensions[i]) names.push_back("tension of " + cable);
  }
  for (Eigen::Index k = 0; k < 6; ++k) {
    if (load(k)) names.push_back(std::string("known load, ") + kComponents[k]);
  }
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace cdpr_kinetostatics

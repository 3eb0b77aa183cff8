#include "tradeoff/trial.h"

namespace cdpr_kinetostatics {

const char* problemName(Problem problem) {
  switch (problem) {
    case Problem::kForwardCold:
      return "forward_cold";
    case Problem::kForwardWarm:
      return "forward_warm";
    case Problem::kInverse:
      return "inverse";
    case Problem::kEstimate:
      return "estimate";
    case Problem::kCablePosition:
      return "cable_position";
    case Problem::kCableForces:
      return "cable_forces";
    case Problem::kCableLength:
      return "cable_length";
  }
  return "unknown";
}

std::vector<std::unique_ptr<Trial>> trialsOf(Problem problem, const RobotDescription& robot,
                                             const std::vector<Scenario>& scenarios, const Setting& setting) {
  const bool one_cable =
      problem == Problem::kCablePosition || problem == Problem::kCableForces || problem == Problem::kCableLength;
  std::vector<std::unique_ptr<Trial>> trials;
  for (const Scenario& scenario : scenarios) {
    if (!one_cable) {
      trials.push_back(makeRobotTrial(problem, robot, scenario, setting));
      continue;
    }
    for (std::size_t i = 0; i < robot.cables.size(); ++i) {
      trials.push_back(
          makeCableTrial(problem, robot.cables[i].properties, scenario.reference.cables[i].cable, setting));
    }
  }
  return trials;
}

}  // namespace cdpr_kinetostatics

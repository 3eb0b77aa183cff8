#include "measured_truth.h"

namespace cdpr_kinetostatics {

MeasuredRobot measuredBy(const SimulatedRobot& simulated, const CableMeasurements& measurements) {
  const std::size_t n = simulated.robot.cables.size();
  Selection all{std::vector<bool>(n, true), std::vector<bool>(n, true)};
  all.load.head(simulated.robot.freedoms()).setConstant(true);
  return {simulated.robot,
          simulated.estimator,
          measurements,
          std::chrono::steady_clock::now() + std::chrono::minutes(1),
          all,
          std::vector<Model>(n, simulated.estimator.model)};
}

RobotForces truthOf(const SimulatedRobot& simulated) {
  RobotForces truth;
  truth.pose = simulated.truth.pose;
  for (const CableResult& cable : simulated.truth.cables) {
    truth.lengths.push_back(cable.cable.length);
    truth.forces.push_back({cable.cable.horizontal_force, cable.cable.vertical_force_a});
  }
  return truth;
}

}  // namespace cdpr_kinetostatics

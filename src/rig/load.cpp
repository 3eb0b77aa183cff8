#include "rig/load.h"

#include <cmath>
#include <random>

namespace cdpr_kinetostatics {

Wrench rigLoad(const RigParameters& parameters, double time) {
  Wrench load = Wrench::Zero();
  for (const RigLoad& step : parameters.loads) {
    if (step.time <= time) load = step.wrench;
  }
  return load;
}

Wrench unknownRigLoad(const RigParameters& parameters, double time) {
  const RobotDescription& robot = parameters.robot;
  // The drawn loads have seeds of their own, so that the sensors' noise is the same with and without them.
  std::seed_seq seed{parameters.sensors.seed, static_cast<int>(std::floor(time)), 1};
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Wrench load;
  for (Eigen::Index k = 0; k < 6; ++k) load(k) = parameters.load_noise * robot.weight() * normal(random);
  load.tail<3>() *= robot.type == PlatformType::kPointMass ? 0.0 : robot.platformRadius();
  return load;
}

}  // namespace cdpr_kinetostatics

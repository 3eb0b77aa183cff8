// What the cables of the simulated rig are in truth, at a pose and under a load.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_solution.h"
#include "rig/parameters.h"

namespace cdpr_kinetostatics {

struct RigTruth {
  Pose pose;                     // as reached: a free attitude or an unknown load take it away from the one asked for
  std::vector<double> lengths;   // unstrained [m]
  std::vector<double> tensions;  // at A [N]
};

// Inverse kinetostatics; robots with fewer than six cables take the attitude that balances. If the pose cannot be held,
// the status says why and the truth is not to be used.
Status solveRig(const RigParameters& parameters, const Pose& pose, const Wrench& load, Model model, RigTruth* truth);

// Forward kinetostatics: where the platform of `truth` goes under another load, at the lengths that it has.
Status disturbRig(const RigParameters& parameters, const Wrench& load, RigTruth* truth);

// What was solved during the first lap of a path. Later laps repeat it without solving, so that the rig can run at a
// higher rate than its solves would allow.
class RigLap {
 public:
  // With 0 steps nothing is remembered.
  explicit RigLap(std::size_t steps) : truths_(steps) {}

  // Null if that step has not been solved under this load.
  const RigTruth* find(std::uint64_t step, const Wrench& load) const;
  void remember(std::uint64_t step, const Wrench& load, const RigTruth& truth);

 private:
  std::vector<std::optional<RigTruth>> truths_;
  Wrench load_ = Wrench::Zero();  // of all of them
};

}  // namespace cdpr_kinetostatics

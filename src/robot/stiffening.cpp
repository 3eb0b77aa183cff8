#include "robot/stiffening.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {
namespace {

// Strain of the softest cables under the load, how much stiffer the next ones are, and the least that they may be.
constexpr double kSoftStrain = 0.01;
constexpr double kStiffening = 10.0;
constexpr double kLeastStiffening = 1.05;

// Cables of at most this axial stiffness [N].
RobotDescription softened(const RobotDescription& robot, double axial_stiffness) {
  RobotDescription soft = robot;
  for (CableDescription& cable : soft.cables) {
    cable.properties.axial_stiffness = std::min(cable.properties.axial_stiffness, axial_stiffness);
  }
  return soft;
}

// Every cable in its own equilibrium between its ends at the pose, or else under the forces that it had; false where it
// had none.
bool startCables(const RobotDescription& robot, const std::vector<double>& lengths, const std::vector<Model>& rungs,
                 const CoupledOptions& options, CoupledState* state) {
  std::vector<SaggingCable> cables;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    SaggingCable cable(robot.cables[i].properties, rungs[i], options.tolerance);
    const CablePlane plane = cablePlane(robot.cables[i], state->pose);
    if (!cable.startBetween(lengths[i], plane.x, plane.y, {options.tolerance, options.deadline}).ok()) {
      if (state->cables.empty()) return false;
      const SaggingCable& last = state->cables[i];
      cable.start(lengths[i], {last.horizontalForce(), last.verticalForceA()});
    }
    cables.push_back(std::move(cable));
  }
  state->cables = std::move(cables);
  return true;
}

}  // namespace

SearchOutcome stiffen(const RobotDescription& robot, const Wrench& external, const std::vector<double>& lengths,
                      const std::vector<Model>& rungs, const CoupledOptions& options, CoupledNewton* newton,
                      CoupledState* state) {
  double stiffest = 0.0;
  for (const CableDescription& cable : robot.cables) stiffest = std::max(stiffest, cable.properties.axial_stiffness);
  const std::vector<Model> extensible(rungs.size(), Model::kBending);
  const Status none = {Code::kNotConverged,
                       "no stable pose was found at which cables of these lengths balance the load"};
  double reached = 0.0;
  double next = std::max(robot.weight(), external.head<3>().norm()) / kSoftStrain;
  double factor = kStiffening;
  int iterations = 0;
  state->cables.clear();
  for (;;) {
    const bool real = next >= stiffest;
    const RobotDescription soft = softened(robot, next);
    CoupledNewton soft_newton(soft);
    CoupledNewton* used = real ? newton : &soft_newton;
    CoupledState there = *state;
    SearchOutcome outcome;
    outcome.status = none;
    if (startCables(real ? robot : soft, lengths, real ? rungs : extensible, options, &there)) {
      outcome = solveCoupled(external, options, used, &there);
    }
    iterations += outcome.iterations;
    const bool on_branch = outcome.ok() && isOnBranch(platformStability(robot, used->stiffness()), there);
    if (on_branch) {
      *state = std::move(there);
      reached = next;
    } else {
      factor = std::sqrt(factor);
    }
    const bool stuck = reached == 0.0 || factor < kLeastStiffening;
    if (on_branch ? real : stuck || outcome.status.code == Code::kTimedOut) {
      outcome.iterations = iterations;
      if (outcome.ok() && !on_branch) outcome.status = none;
      return outcome;
    }
    next = factor * reached;
  }
}

}  // namespace cdpr_kinetostatics

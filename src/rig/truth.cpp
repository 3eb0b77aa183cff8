#include "rig/truth.h"

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"

namespace cdpr_kinetostatics {

namespace {

RobotSolverOptions optionsOf(const RigParameters& parameters, Model model) {
  RobotSolverOptions options;
  options.model = model;
  options.tolerance = parameters.tolerance;
  options.timeout = std::chrono::duration<double>(5.0);
  return options;
}

}  // namespace

Status solveRig(const RigParameters& parameters, const Pose& pose, const Wrench& load, Model model, RigTruth* truth) {
  const RobotDescription& robot = parameters.robot;
  InverseRequest request;
  request.pose = pose;
  request.free_orientation = robot.type == PlatformType::kRigidBody && robot.cables.size() < 6;
  request.external_wrench = load;
  const RobotSolution solution = solveInverse(robot, request, optionsOf(parameters, model));
  *truth = {solution.pose, lengthsOf(solution), tensionsOf(solution)};
  return solution.report.status;
}

Status disturbRig(const RigParameters& parameters, const Wrench& load, RigTruth* truth) {
  ForwardRequest request;
  request.lengths = truth->lengths;
  request.external_wrench = load;
  request.seed = truth->pose;
  const RobotSolution solution = solveForward(parameters.robot, request, optionsOf(parameters, parameters.model));
  *truth = {solution.pose, lengthsOf(solution), tensionsOf(solution)};
  return solution.report.status;
}

const RigTruth* RigLap::find(std::uint64_t step, const Wrench& load) const {
  if (truths_.empty() || load != load_) return nullptr;
  const std::optional<RigTruth>& truth = truths_[step % truths_.size()];
  return truth ? &*truth : nullptr;
}

void RigLap::remember(std::uint64_t step, const Wrench& load, const RigTruth& truth) {
  if (truths_.empty()) return;
  if (load != load_) {
    truths_.assign(truths_.size(), std::nullopt);
    load_ = load;
  }
  truths_[step % truths_.size()] = truth;
}

}  // namespace cdpr_kinetostatics

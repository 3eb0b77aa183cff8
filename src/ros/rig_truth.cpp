#include "cdpr_kinetostatics/ros/rig_truth.h"

#include "cdpr_kinetostatics/robot/inverse.h"

namespace cdpr_kinetostatics {

Status solveRig(const RigParameters& parameters, const Pose& pose, const Wrench& load, Model model, RigTruth* truth) {
  const RobotDescription& robot = parameters.robot;
  InverseRequest request;
  request.pose = pose;
  request.free_orientation = robot.type == PlatformType::kRigidBody && robot.cables.size() < 6;
  request.external_wrench = load;
  RobotSolverOptions options;
  options.model = model;
  options.tolerance = parameters.tolerance;
  options.timeout = std::chrono::duration<double>(5.0);
  const RobotSolution solution = solveInverse(robot, request, options);
  *truth = RigTruth();
  truth->pose = solution.pose;
  for (const CableResult& cable : solution.cables) {
    truth->lengths.push_back(cable.cable.length);
    truth->tensions.push_back(cable.cable.tension_a);
  }
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

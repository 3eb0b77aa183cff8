#include "robot/rung_choice.h"

#include <algorithm>

#include "robot/linear_robot.h"
#include "robot/platform_statics.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
namespace {

double sizeOf(const Wrench& displacement) {
  return std::max(displacement.head<3>().norm(), displacement.tail<3>().norm());
}

std::size_t rungIndex(Model model) {
  return static_cast<std::size_t>(std::find(kAutoRungs.begin(), kAutoRungs.end(), model) - kAutoRungs.begin());
}

// The coarsest rungs whose joint error is within budget [m].
void findCoarsest(const std::vector<RungEffects>& cables, double budget, std::vector<std::size_t>* rungs) {
  rungs->assign(cables.size(), 0);
  for (std::size_t i = 0; i < cables.size(); ++i) {
    while (!cables[i].known[(*rungs)[i]]) ++(*rungs)[i];
  }
  for (;;) {
    Wrench total = Wrench::Zero();
    double uncertain = 0.0;
    double largest = 0.0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < cables.size(); ++i) {
      const std::size_t rung = (*rungs)[i];
      const Wrench& displacement = cables[i].displacement[rung];
      const double size = sizeOf(displacement);
      total += displacement;
      uncertain += (isStraight(kAutoRungs[rung]) ? kUncertainLine : kUncertain) * size;
      if (size > largest) {
        largest = size;
        worst = i;
      }
    }
    if (largest == 0.0 || sizeOf(total) + uncertain <= budget) return;
    ++(*rungs)[worst];
  }
}

}  // namespace

const std::vector<Model>& RungChoice::choose(const std::vector<RungEffects>& cables, double accuracy,
                                             const std::vector<Model>& kept) {
  findCoarsest(cables, kAutoShare * accuracy, &needed_);
  if (!kept.empty()) findCoarsest(cables, kKeptShare * kAutoShare * accuracy, &ample_);
  rungs_.resize(cables.size());
  for (std::size_t i = 0; i < cables.size(); ++i) {
    std::size_t rung = needed_[i];
    if (!kept.empty()) rung = std::max(rung, std::min(rungIndex(kept[i]), ample_[i]));
    rungs_[i] = kAutoRungs[rung];
  }
  return rungs_;
}

const std::vector<Model>& RungChoice::choose(const RobotDescription& robot, const RobotForces& state, double accuracy,
                                             const std::vector<Model>& kept) {
  if (estimate(robot, state)) return choose(effects_, accuracy, kept);
  rungs_.assign(robot.cables.size(), Model::kBending);
  return rungs_;
}

bool RungChoice::serve(const RobotDescription& robot, const RobotForces& state, double accuracy,
                       const std::vector<Model>& used) {
  choose(robot, state, accuracy, used);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (rungs_[i] > used[i]) return false;
  }
  needlessly_fine_ = rungs_ == used ? 0 : needlessly_fine_ + 1;
  if (needlessly_fine_ <= kNeedlesslyFine) return true;
  needlessly_fine_ = 0;
  return false;
}

// False where the robot has no stiffness.
bool RungChoice::estimate(const RobotDescription& robot, const RobotForces& state) {
  const std::size_t count = robot.cables.size();
  LinearRobot linear(robot);
  linear.start(state.pose);
  errors_.resize(count);
  effects_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const CableProperties& properties = robot.cables[i].properties;
    const double h = state.forces[i].horizontal;
    const double v = state.forces[i].vertical;
    const CablePlane plane = cablePlane(robot.cables[i], state.pose);
    errors_[i] = rungErrors(properties, state.lengths[i], h, v);
    linear.add(plane, errors_[i].front().stiffness, h,
               forceOnPlatform(plane, h, v, properties.weight * freeLengthUnder(properties, state.lengths[i], {h, v})));
  }
  if (!linear.factorise()) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Matrix<double, 6, 2> moved =
        linear.displacement(wrenchByForces(cablePlane(robot.cables[i], state.pose)));
    for (std::size_t r = 0; r < errors_[i].size(); ++r) {
      effects_[i].displacement[r] = moved * errors_[i][r].force;
      effects_[i].known[r] = errors_[i][r].known;
    }
  }
  return true;
}

bool refineRungs(std::vector<Model>* rungs) {
  bool any = false;
  for (Model& model : *rungs) {
    if (model == Model::kBending) continue;
    model = kAutoRungs[rungIndex(model) + 1];
    any = true;
  }
  return any;
}

}  // namespace cdpr_kinetostatics

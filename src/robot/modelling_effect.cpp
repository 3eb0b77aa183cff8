#include "cdpr_kinetostatics/robot/modelling_effect.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "cdpr_kinetostatics/robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

// A cable's estimate is to leading order: this share of it counts as uncertain.
constexpr double kUncertain = 0.2;
constexpr double kUncertainLine = 0.5;

// And this share of the accuracy is enough in the end: the estimate at the solution is a little other than the one
// before it.
constexpr double kEnough = 0.75;

// Sag is no small effect for a nearly slack line, whose estimate is the rougher.
constexpr double kEnoughOnLines = 0.4;

// AUTO gives up a rung in use only for one that would do for this share of the accuracy.
constexpr double kKeptShare = 0.5;

// Wrench of a change of a cable's forces (H, V) at a fixed end.
Eigen::Matrix<double, 6, 2> wrenchByForces(const CableLine& line) {
  Eigen::Matrix<double, 6, 2> wrench;
  wrench << wrenchAt(line.arm, -line.direction), wrenchAt(line.arm, Eigen::Vector3d::UnitZ());
  return wrench;
}

// A robot in equilibrium, to first order.
class LinearRobot {
 public:
  explicit LinearRobot(const RobotDescription& robot, const Pose& pose)
      : radius_(std::max(robot.platformRadius(), 1e-6 * robot.span())), stiffness_(weightStiffness(robot, pose)) {
    rigid_ = robot.type == PlatformType::kRigidBody;
  }

  // stiffness: d(H, V)/d(x, w).
  void add(const CableLine& line, const Eigen::Matrix2d& stiffness, double h, const Eigen::Vector3d& force) {
    Eigen::Matrix<double, 2, 6> end_by_pose;
    end_by_pose.leftCols<3>() << line.direction.transpose(), Eigen::RowVector3d::UnitZ();
    end_by_pose.rightCols<3>() = end_by_pose.leftCols<3>() * -cross(line.arm);
    const Eigen::Vector3d side(-line.direction.y(), line.direction.x(), 0.0);
    Wrench side_wrench = wrenchAt(line.arm, side);
    Matrix6 added = wrenchByForces(line) * stiffness * end_by_pose -
                    h / std::max(line.x, 1e-9 * std::hypot(line.x, line.w)) * side_wrench * side_wrench.transpose();
    added.bottomRightCorner<3, 3>() += cross(force) * cross(line.arm);
    if (rigid_) {
      stiffness_ += added;
    } else {
      stiffness_.topLeftCorner<3, 3>() += added.topLeftCorner<3, 3>();
    }
  }

  // False where the stiffness is singular.
  bool factorise() {
    // A point mass's rotations are as stiff as its translations: they take no part, and hide no singularity.
    if (!rigid_) stiffness_.diagonal().tail<3>().setConstant(stiffness_.topLeftCorner<3, 3>().cwiseAbs().maxCoeff());
    Wrench scale;
    scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(rigid_ ? 1.0 / radius_ : 1.0);
    lu_.compute(scale.asDiagonal() * stiffness_ * scale.asDiagonal());
    scale_ = scale;
    return stiffness_.allFinite() && lu_.rcond() > 1e-15;
  }

  // Where an unbalanced wrench takes the platform: translation, and rotation times the platform's radius [m].
  Wrench displacement(const Wrench& wrench) const {
    Wrench moved = lu_.solve(-(scale_.asDiagonal() * wrench));
    if (!rigid_) moved.tail<3>().setZero();
    return moved;
  }

  double radius() const { return radius_; }

 private:
  const double radius_;
  bool rigid_ = true;
  Matrix6 stiffness_;
  Wrench scale_ = Wrench::Ones();
  Eigen::PartialPivLU<Matrix6> lu_;
};

double sizeOf(const Wrench& displacement) {
  return std::max(displacement.head<3>().norm(), displacement.tail<3>().norm());
}

std::size_t rungIndex(Model model) {
  return static_cast<std::size_t>(std::find(kAutoRungs.begin(), kAutoRungs.end(), model) - kAutoRungs.begin());
}

// The coarsest rungs whose joint error is within budget [m].
std::vector<std::size_t> coarsest(const std::vector<RungEffects>& cables, double budget) {
  std::vector<std::size_t> rungs(cables.size(), 0);
  for (std::size_t i = 0; i < cables.size(); ++i) {
    while (!cables[i].known[rungs[i]]) ++rungs[i];
  }
  for (;;) {
    Wrench total = Wrench::Zero();
    double uncertain = 0.0;
    double largest = 0.0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < cables.size(); ++i) {
      const Wrench& displacement = cables[i].displacement[rungs[i]];
      const double size = sizeOf(displacement);
      total += displacement;
      uncertain += (isStraight(kAutoRungs[rungs[i]]) ? kUncertainLine : kUncertain) * size;
      if (size > largest) {
        largest = size;
        worst = i;
      }
    }
    if (largest == 0.0 || sizeOf(total) + uncertain <= budget) return rungs;
    ++rungs[worst];
  }
}

}  // namespace

PlatformError platformError(const RobotDescription& robot, const Pose& pose, const std::vector<CableSolution>& cables) {
  PlatformError error;
  LinearRobot linear(robot, pose);
  Wrench unbalanced = Wrench::Zero();
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const CableProperties& properties = robot.cables[i].properties;
    const CableLine line = cableLine(robot.cables[i], pose);
    const ModelError of_cable = modelError(properties, cables[i]);
    const double h = cables[i].horizontal_force;
    const double v = cables[i].vertical_force_a;
    linear.add(line, of_cable.stiffness, h, forceOnPlatform(line, h, v, properties.weight * cables[i].length));
    unbalanced += wrenchByForces(line) * of_cable.force;
    error.known = error.known && of_cable.known;
    error.cables.push_back(of_cable.end.norm());
  }
  if (!linear.factorise()) {
    error.known = false;
    return error;
  }
  const Wrench displacement = linear.displacement(unbalanced);
  error.translation = displacement.head<3>().norm();
  error.rotation = displacement.tail<3>().norm() / linear.radius();
  return error;
}

bool isWithin(const RobotDescription& robot, const RobotSolution& solution, double accuracy) {
  const RobotReport& report = solution.report;
  const double error = std::max(report.estimated_error, report.estimated_rotation_error * robot.platformRadius());
  const bool lines = std::any_of(solution.cables.begin(), solution.cables.end(),
                                 [](const CableResult& cable) { return isStraight(cable.cable.model); });
  return report.error_known && error <= (lines ? kEnoughOnLines : kEnough) * accuracy;
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

std::string describeChoice(const RobotSolution& solution) {
  std::ostringstream text;
  const char* separator = "";
  for (const Model model : kAutoRungs) {
    const auto count = std::count_if(solution.cables.begin(), solution.cables.end(),
                                     [&](const CableResult& cable) { return cable.cable.model == model; });
    if (count == 0) continue;
    text << separator << modelName(model) << " for " << count << (count == 1 ? " cable" : " cables");
    separator = ", ";
  }
  if (solution.report.model != Model::kBending || solution.report.estimated_error > 0.0) {
    text.precision(2);
    text << "; what this neglects moves the platform by " << solution.report.estimated_error << " m";
  }
  return text.str();
}

std::vector<RungEffects> rungEffects(const RobotDescription& robot, const RobotForces& state) {
  const std::size_t count = robot.cables.size();
  LinearRobot linear(robot, state.pose);
  std::vector<RungErrors> errors(count);
  std::vector<CableLine> lines(count);
  for (std::size_t i = 0; i < count; ++i) {
    const CableProperties& properties = robot.cables[i].properties;
    const double h = state.forces[i].horizontal;
    const double v = state.forces[i].vertical;
    lines[i] = cableLine(robot.cables[i], state.pose);
    errors[i] = rungErrors(properties, state.lengths[i], h, v);
    linear.add(lines[i], errors[i].front().stiffness, h,
               forceOnPlatform(lines[i], h, v, properties.weight * state.lengths[i]));
  }
  if (!linear.factorise()) return {};
  std::vector<RungEffects> effects(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Matrix<double, 6, 2> wrench = wrenchByForces(lines[i]);
    for (std::size_t r = 0; r < errors[i].size(); ++r) {
      effects[i].displacement[r] = linear.displacement(wrench * errors[i][r].force);
      effects[i].known[r] = errors[i][r].known;
    }
  }
  return effects;
}

std::vector<Model> chooseRungs(const std::vector<RungEffects>& cables, double accuracy,
                               const std::vector<Model>& kept) {
  const std::vector<std::size_t> needed = coarsest(cables, kAutoShare * accuracy);
  std::vector<std::size_t> ample = needed;
  if (!kept.empty()) ample = coarsest(cables, kKeptShare * kAutoShare * accuracy);
  std::vector<Model> rungs(cables.size());
  for (std::size_t i = 0; i < cables.size(); ++i) {
    std::size_t rung = needed[i];
    if (!kept.empty()) rung = std::max(rung, std::min(rungIndex(kept[i]), ample[i]));
    rungs[i] = kAutoRungs[rung];
  }
  return rungs;
}

std::vector<Model> chooseRungs(const RobotDescription& robot, const RobotForces& state, double accuracy) {
  const std::vector<RungEffects> effects = rungEffects(robot, state);
  if (effects.empty()) return std::vector<Model>(robot.cables.size(), Model::kBending);
  return chooseRungs(effects, accuracy, {});
}

}  // namespace cdpr_kinetostatics

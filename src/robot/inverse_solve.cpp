#include "robot/inverse_solve.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cable/iteration_schedule.h"
#include "robot/platform_error.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxIterations = 2000;

// How far the starting rung is taken where another one follows.
constexpr double kRough = 1e-3;

// Limits that still contradict each other after so many iterations do.
constexpr int kIterationsToFeasibility = 8;

// Weight of a turn of a free attitude in the objective: it decides only where equilibrium and tensions leave the
// attitude free.
constexpr double kTurnWeight = 1e-2;  // [1/rad]

}  // namespace

InverseSolve::InverseSolve(const RobotDescription& robot, const RobotSolverOptions& options)
    : robot_(robot), options_(options) {}

RungOptions InverseSolve::roughly() const {
  RungOptions options;
  options.model = startingRung(options_.model);
  options.limits = {1e-6, deadline_};
  return options;
}

void InverseSolve::begin(const InverseRequest& request) {
  request_ = request;
  pose_ = request.pose;
  free_turn_ = request.free_orientation && robot_.type == PlatformType::kRigidBody;
  preferred_.resize(static_cast<Eigen::Index>(robot_.cables.size()));
  for (Eigen::Index i = 0; i < preferred_.size(); ++i) {
    const CableDescription& cable = robot_.cables[i];
    preferred_(i) = request.preferred_tensions.empty() ? 0.5 * (cable.tension_min + cable.tension_max)
                                                       : request.preferred_tensions[i];
  }
  turn_weight_ = kTurnWeight;
  iterations_ = 0;
}

Status InverseSolve::solve(const InverseRequest& request, Clock::time_point deadline) {
  deadline_ = deadline;
  begin(request);
  Status status = run(options_.model);
  if (options_.model == Model::kAuto &&
      (status.code == Code::kNotConverged || status.code == Code::kWrongBranch || status.code == Code::kInfeasible)) {
    begin(request);
    status = run(Model::kBending);
  }
  return status;
}

Status InverseSolve::run(Model model) {
  const bool choose = model == Model::kAuto;
  distribution_ = {};
  Status status = startCables();
  rungs_.assign(robot_.cables.size(), model);
  if (status.ok() && startingRung(model) != model) {
    status = iterate(kRough);
    if (choose && status.ok()) rungs_ = choice_.choose(robot_, reached(), options_.accuracy, {});
    if (status.ok()) useRungs(rungs_);
  }
  if (status.ok()) status = iterate(options_.tolerance);
  if (status.ok()) status = checkBranches();
  while (choose && status.ok() && !isWithin(robot_, solution(), options_.accuracy) && refineRungs(&rungs_)) {
    useRungs(rungs_);
    status = iterate(options_.tolerance);
    if (status.ok()) status = checkBranches();
  }
  return status;
}

RobotSolution InverseSolve::solution() const {
  RobotSolution solution;
  solution.pose = pose_;
  solution.report.status.code = Code::kConverged;
  solution.report.iterations = iterations_;
  std::vector<CableSolution> cables;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const CablePlane plane = cablePlane(robot_.cables[i], pose_);
    cables.push_back(cables_[i].cable.describe(plane.x, plane.y, options_.profile_points));
  }
  assemble(robot_, request_.external_wrench, cables, &solution);
  if (options_.model == Model::kAuto) solution.report.status.message = describeChoice(solution);
  return solution;
}

// Every cable at its preferred tension, moved into its limits, on the closed-form rung.
Status InverseSolve::startCables() {
  const RungOptions options = roughly();
  cables_.clear();
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CableDescription& description = robot_.cables[i];
    InverseCable cable;
    cable.cable = SaggingCable(description.properties, options.model, options_.tolerance);
    cable.plane = cablePlane(description, pose_);
    cable.lower = description.tension_min;
    cable.upper = description.tension_max;
    double tension =
        std::clamp(preferred_(static_cast<Eigen::Index>(i)), std::max(cable.lower, 1e-9 * cable.upper), cable.upper);
    CableSolution start = lengthOnRung(description.properties, cable.plane.x, cable.plane.y, tension, 0.0, options);
    if (start.status.code == Code::kInfeasible && start.least_tension > 0.0) {
      cable.lower = kAboveFold * start.least_tension;
      tension = cable.lower;
      start = lengthOnRung(description.properties, cable.plane.x, cable.plane.y, tension, 0.0, options);
    }
    if (!start.status.ok()) {
      return {start.status.code, "cable '" + description.name + "': " + start.status.message};
    }
    cable.cable.start(start.length, {start.horizontal_force, start.vertical_force_a});
    cables_.push_back(std::move(cable));
  }
  return {Code::kConverged, ""};
}

RobotForces InverseSolve::reached() const {
  RobotForces forces;
  forces.pose = pose_;
  for (const InverseCable& c : cables_) {
    forces.lengths.push_back(c.cable.length());
    forces.forces.push_back({c.cable.horizontalForce(), c.cable.verticalForceA()});
  }
  return forces;
}

// The same forces and lengths on other rungs.
void InverseSolve::useRungs(const std::vector<Model>& rungs) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const SaggingCable& old = cables_[i].cable;
    if (old.model() == rungs[i]) continue;
    SaggingCable cable(robot_.cables[i].properties, rungs[i], options_.tolerance);
    cable.start(old.length(), {old.horizontalForce(), old.verticalForceA()});
    cables_[i].cable = std::move(cable);
  }
}

bool InverseSolve::linearise(Steps steps) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    InverseCable& c = cables_[i];
    const bool adapt = steps == Steps::kNew || (steps == Steps::kNewWhereDue && !c.cable.stepsFit());
    if (!c.cable.linearise(adapt)) return false;
    c.plane = cablePlane(robot_.cables[i], pose_);
    const double tension = c.cable.tensionA();
    Eigen::Matrix3d system;
    system << c.cable.end().jacobian, c.cable.horizontalForce() / tension, c.cable.verticalForceA() / tension, 0.0;
    const Eigen::Matrix3d inverse = system.inverse();
    const Eigen::Vector2d defect = Eigen::Vector2d(c.plane.x, c.plane.y) - c.cable.end().position;
    c.by_end = inverse.leftCols<2>();
    c.start = c.by_end * defect;
    c.by_tension = inverse.col(2);
    c.by_turn = c.by_end * c.plane.toPlane() * -cross(c.plane.arm);
    if (!inverse.allFinite()) return false;
  }
  return true;
}

Status InverseSolve::iterate(double tolerance) {
  bool adapt = true;
  double last_size = std::numeric_limits<double>::infinity();
  Eigen::Vector3d last_turn = Eigen::Vector3d::Zero();
  for (int i = 0; i < kMaxIterations; ++i) {
    if (Clock::now() > deadline_) {
      return {Code::kTimedOut, "the time allowed ran out while the tensions were distributed"};
    }
    ++iterations_;
    if (!linearise(adapt ? Steps::kNew : Steps::kKept)) break;
    if (pullBackFromFolds() && !linearise(Steps::kNew)) break;
    distribution_ = distribute();
    for (int k = 0; k < 3 && raiseLimitsToFolds(distribution_.tensions); ++k) distribution_ = distribute();
    const auto n = static_cast<Eigen::Index>(cables_.size());
    const Eigen::VectorXd tensions = distribution_.tensions.head(n);
    const Eigen::Vector3d turn =
        free_turn_ ? Eigen::Vector3d(distribution_.tensions.tail<3>()) : Eigen::Vector3d::Zero();
    double damping = 1.0;
    // A heavy turn takes short steps: what counts is the slope that is left.
    double size = turn.norm() * std::max(1.0, turn_weight_ * turn_weight_);
    for (Eigen::Index k = 0; k < n; ++k) {
      const InverseCable& c = cables_[k];
      const Eigen::Vector3d change = c.change(tensions(k), turn);
      if (!change.allFinite())
        return {Code::kNotConverged, "the tensions did not settle: a cable has no stiffness here"};
      damping = std::min(damping, c.cable.dampingFor(change));
      size = std::max({size, change.head<2>().norm() / c.cable.tensionA(), std::abs(change.z()) / c.cable.length(),
                       c.cable.angleChange(change)});
    }
    for (Eigen::Index k = 0; k < n; ++k) cables_[k].cable.step(cables_[k].change(tensions(k), turn), damping);
    pose_ = displaced(pose_, Eigen::Vector3d::Zero(), damping * turn);
    // The turn has no curvature in the linearised problem: where it swings, its weight grows.
    if (i > 0 && (turn.dot(last_turn) < 0.0 || size > 1.5 * last_size)) turn_weight_ *= 1.5;
    last_turn = turn;
    const bool settled = size <= tolerance || (size < 1e-6 && size >= 0.5 * last_size);
    if ((settled && !adapt) || i >= kIterationsToFeasibility) {
      if (!distribution_.feasible) return contradiction(distribution_);
    }
    if (settled && !adapt) {
      if (!isBalanced()) return unbalanced(distribution_.imbalance);
      return {Code::kConverged, ""};
    }
    adapt = choosesStepsNext(size, i);
    last_size = size;
  }
  return {Code::kNotConverged, "the tensions did not settle at this pose"};
}

}  // namespace cdpr_kinetostatics

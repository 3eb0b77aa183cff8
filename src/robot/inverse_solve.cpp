#include "robot/inverse_solve.h"

#include <algorithm>
#include <limits>

#include "cable/iteration_schedule.h"
#include "robot/platform_error.h"
#include "robot/platform_statics.h"
#include "robot/solution_assembly.h"
#include "robot/tension_limits.h"

namespace cdpr_kinetostatics {
namespace {

// A free attitude may creep along a valley; whoever waits is bounded by the deadline.
constexpr int kMaxIterations = 2000;

// How far the starting model is taken where another one follows.
constexpr double kRough = 1e-3;

// Tolerance of the closed-form problem 3 behind starts and folds: better than any use of them needs.
constexpr double kClosedFormTolerance = 1e-6;

// Limits that still contradict each other after so many iterations do.
constexpr int kIterationsToFeasibility = 8;

// A step that has grown by more than this means that the turn of a free attitude swings.
constexpr double kSwing = 1.5;

// Steps that have stopped to shrink are rounding if they are smaller than this. Smaller than in Newton's methods: the
// curvature of the constraints is left out of the program, so that steps shrink only linearly.
constexpr double kRoundingStep = 1e-6;

// A prediction along a path that changes forces or lengths by more than this share is a jump.
constexpr double kLongestReach = 0.5;

// Along a path, more linearisations than this are no gain.
constexpr int kMostLinearisations = 8;

bool hasSettled(double size, double last_size, double tolerance) {
  return size <= tolerance || (size < kRoundingStep && size >= 0.5 * last_size);
}

}  // namespace

InverseSolve::InverseSolve(const RobotDescription& robot, const RobotSolverOptions& options)
    : robot_(robot), options_(options), iteration_(robot) {}

RungOptions InverseSolve::closedForm() const {
  RungOptions options;
  options.model = startingRung(options_.model);
  options.limits = {kClosedFormTolerance, deadline_};
  return options;
}

const Status& InverseSolve::solve(const InverseRequest& request, Clock::time_point deadline) {
  deadline_ = deadline;
  outcome_ = {};
  external_ = request.external_wrench;
  iteration_.begin(request);
  outcome_.status = run(options_.model);
  const Code code = outcome_.status.code;
  if (options_.model == Model::kAuto &&
      (code == Code::kNotConverged || code == Code::kWrongBranch || code == Code::kInfeasible)) {
    outcome_ = {};
    iteration_.begin(request);
    outcome_.status = run(Model::kBending);
  }
  return outcome_.status;
}

Status InverseSolve::run(Model model) {
  const bool choose = model == Model::kAuto;
  Status status = iteration_.startCables(closedForm(), options_.tolerance);
  rungs_.assign(robot_.cables.size(), model);
  if (status.ok() && startingRung(model) != model) {
    status = iterate(kRough);
    if (choose && status.ok()) rungs_ = choice_.choose(robot_, iteration_.reached(), options_.accuracy, {});
    if (status.ok()) iteration_.useRungs(rungs_, options_.tolerance);
  }
  if (status.ok()) status = settle(options_.tolerance);
  while (choose && status.ok()) {
    outcome_.status = status;
    if (isWithin(robot_, solution(), options_.accuracy) || !refineRungs(&rungs_)) break;
    iteration_.useRungs(rungs_, options_.tolerance);
    status = settle(options_.tolerance);
  }
  return status;
}

RobotSolution InverseSolve::solution() const {
  if (!outcome_.ok()) return failedRobot(options_.model, outcome_);
  RobotSolution solution;
  solution.pose = iteration_.pose();
  solution.report.status.code = Code::kConverged;
  solution.report.iterations = outcome_.iterations;
  std::vector<CableSolution> cables;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot_.cables[i], solution.pose);
    cables.push_back(iteration_.cables()[i].cable.describe(plane.x, plane.y, options_.profile_points));
  }
  assemble(robot_, external_, cables, &solution);
  if (options_.model == Model::kAuto) solution.report.status.message = describeChoice(solution);
  return solution;
}

Status InverseSolve::iterate(double tolerance) {
  const RungOptions closed_form = closedForm();
  bool adapt = true;
  double last_size = std::numeric_limits<double>::infinity();
  Eigen::Vector3d last_turn = Eigen::Vector3d::Zero();
  for (int i = 0; i < kMaxIterations; ++i) {
    if (Clock::now() > deadline_) {
      return {Code::kTimedOut, "the time allowed ran out while the tensions were distributed"};
    }
    ++outcome_.iterations;
    if (!iteration_.linearisedAboveFolds(closed_form, adapt ? Steps::kNew : Steps::kKept)) break;
    outcome_.residuals = iteration_.residuals();
    const InverseIteration::Move move = iteration_.plannedMove();
    if (!move.finite) return {Code::kNotConverged, "the tensions did not settle: a cable has no stiffness here"};
    iteration_.take(move);
    if (i > 0 && (move.turn.dot(last_turn) < 0.0 || move.size > kSwing * last_size)) iteration_.makeTurnHeavier();
    last_turn = move.turn;
    const bool settled = hasSettled(move.size, last_size, tolerance) && !adapt;
    const bool decided = settled || i >= kIterationsToFeasibility;
    if ((decided && !iteration_.isFeasible()) || (settled && !iteration_.isBalanced())) return iteration_.infeasible();
    if (settled) return {Code::kConverged, ""};
    adapt = choosesStepsNext(move.size, i);
    last_size = move.size;
  }
  return {Code::kNotConverged, "the tensions did not settle at this pose"};
}

Status InverseSolve::settle(double tolerance) {
  const Status status = iterate(tolerance);
  return status.ok() ? checkBranches() : status;
}

// A cable that pushes has no place in a solution with tension limits above zero.
Status InverseSolve::checkBranches() const {
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const SaggingCable& cable = iteration_.cables()[i].cable;
    if (cable.pushes() && robot_.cables[i].tension_min > 0.0) {
      return {Code::kInfeasible,
              "cable '" + robot_.cables[i].name + "' would be in compression, which its tension_min forbids"};
    }
    if (!cable.onBranch()) {
      return {Code::kWrongBranch,
              "cable '" + robot_.cables[i].name + "' ended in an equilibrium that is not the sagging one"};
    }
  }
  return {Code::kConverged, ""};
}

bool InverseSolve::follow(const InverseRequest& request) {
  outcome_.iterations = 0;
  external_ = request.external_wrench;
  iteration_.begin(request);
  if (iteration_.isFree()) return false;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    iteration_.cables()[i].lower = robot_.cables[i].tension_min;
  }
  if (!predict() || !converge() || !checkBranches().ok()) return false;
  return options_.model != Model::kAuto || choice_.serve(robot_, iteration_.reached(), options_.accuracy, rungs_);
}

// The cables follow the platform at constant tension.
bool InverseSolve::predict() {
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    InverseCable& c = iteration_.cables()[i];
    const CablePlane plane = cablePlane(robot_.cables[i], iteration_.pose());
    const Eigen::Vector3d change = c.by_end * Eigen::Vector2d(plane.x - c.plane.x, plane.y - c.plane.y);
    if (!(c.size(change) < kLongestReach)) return false;
    c.cable.follow(change);
  }
  return true;
}

// From a state near the solution, and away from folds.
bool InverseSolve::converge() {
  const RungOptions closed_form = closedForm();
  double last_size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostLinearisations; ++i) {
    ++outcome_.iterations;
    if (!iteration_.linearise(Steps::kNewWhereDue)) return false;
    iteration_.distribute();
    if (!iteration_.isFeasible() || !iteration_.isBalanced()) return false;
    if (anyAtFold(iteration_.cables(), iteration_.distribution().tensions, closed_form)) return false;
    const InverseIteration::Move move = iteration_.plannedMove();
    if (!move.finite || move.damping < 1.0) return false;
    iteration_.take(move);
    if (hasSettled(move.size, last_size, options_.tolerance)) return true;
    last_size = move.size;
  }
  return false;
}

}  // namespace cdpr_kinetostatics

#include "robot/inverse_solve.h"

#include <algorithm>
#include <limits>

#include "cable/cable_description.h"
#include "cable/iteration_schedule.h"
#include "cable/rope_on_pulley.h"
#include "cable/text.h"
#include "robot/platform_error.h"
#include "robot/platform_statics.h"
#include "robot/robot_gate.h"
#include "robot/solution_assembly.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
namespace {

// Newton's method on the program needs ten iterations, from the worst starts a hundred; whoever waits is bounded by the
// deadline.
constexpr int kMaxIterations = 300;

// Limits that have not been met in so many iterations will not be: what is left creeps to its least value, or at the
// border of what can be held, where rounding decides, to and fro.
constexpr int kMostInfeasible = 50;

// How far the starting model is taken where another one follows.
constexpr double kRough = 1e-3;

// Steps that have stopped to shrink are rounding if they are smaller than this. Smaller than in Newton's methods: the
// multipliers that weigh the curvature are those of the step before.
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
    : robot_(robot), options_(options), iteration_(robot), linear_(robot) {}

const Status& InverseSolve::solve(const InverseRequest& request, Clock::time_point deadline) {
  deadline_ = deadline;
  request_ = request;
  outcome_ = {};
  outcome_.status = attempt(request.pose.orientation);
  if (iteration_.attitude().freedoms() > 0 && !outcome_.ok() && !isLate()) {
    outcome_.status = searchAttitudes(outcome_.status);
  }
  return outcome_.status;
}

Status InverseSolve::attempt(const Eigen::Quaterniond& attitude) {
  const auto from = [&](Model model) {
    iteration_.begin(request_);
    iteration_.setAttitude(attitude);
    return run(model);
  };
  Status status = from(options_.model);
  if (options_.model == Model::kAuto &&
      (status.code == Code::kNotConverged || status.code == Code::kWrongBranch || status.code == Code::kInfeasible)) {
    status = from(Model::kBending);
  }
  return status.ok() ? judge() : status;
}

Status InverseSolve::run(Model model) {
  const bool choose = model == Model::kAuto;
  Status status = iteration_.startCables(startingRung(model), options_.tolerance);
  rungs_.assign(robot_.cables.size(), model);
  if (status.ok() && startingRung(model) != model) {
    status = iterate(kRough);
    if (choose && status.ok()) rungs_ = choice_.choose(robot_, iteration_.reached(), options_.accuracy, {});
    // What no catenary can do a bar may: the verdict is that of the model asked for.
    if (!choose && status.code == Code::kInfeasible) status.code = Code::kConverged;
    if (status.ok()) iteration_.useRungs(rungs_, {options_.tolerance, deadline_});
  }
  if (status.ok()) status = settle(options_.tolerance);
  while (choose && status.ok()) {
    outcome_.status = status;
    if (isWithin(robot_, solution(), options_.accuracy) || !refineRungs(&rungs_)) break;
    iteration_.useRungs(rungs_, {options_.tolerance, deadline_});
    status = settle(options_.tolerance);
  }
  return status;
}

RobotSolution InverseSolve::solution() const {
  if (!outcome_.ok() && outcome_.status.code != Code::kUnstable) return failedRobot(options_.model, outcome_);
  RobotSolution solution;
  solution.pose = iteration_.pose();
  solution.report.status = outcome_.status;
  solution.report.iterations = outcome_.iterations;
  std::vector<CableSolution> cables;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot_.cables[i], solution.pose);
    cables.push_back(iteration_.cables()[i].cable.describe(plane.x, plane.y, options_.profile_points));
  }
  assemble(robot_, request_.external_wrench, cables, &solution);
  const Status verdict = verdictOf(robot_, solution, request_.external_wrench, options_.tolerance);
  if (!verdict.ok()) {
    solution.report.status = verdict;
    return failedRobot(options_.model, outcomeOf(solution.report));
  }
  std::string& message = solution.report.status.message;
  if (options_.model == Model::kAuto) message = joined(describeChoice(solution), message);
  return solution;
}

Status InverseSolve::iterate(double tolerance) {
  bool adapt = true;
  int infeasible = 0;  // iterations in which the limits could not be met
  double last_size = std::numeric_limits<double>::infinity();
  if (!iteration_.closeCables(Steps::kNew)) return noStiffness();
  for (int i = 0; i < kMaxIterations; ++i) {
    if (isLate()) return {Code::kTimedOut, "the time allowed ran out while the tensions were distributed"};
    ++outcome_.iterations;
    outcome_.residuals = iteration_.residuals();
    if (!iteration_.distribute(deadline_)) return noStiffness();
    if (isLate()) continue;
    const InverseIteration::Move move = iteration_.plannedMove();
    if (!move.finite || !iteration_.advance(move, adapt ? Steps::kNew : Steps::kKept)) return noStiffness();
    const bool settled = hasSettled(move.size, last_size, tolerance) && !adapt;
    if (!iteration_.isFeasible() && ++infeasible == kMostInfeasible) return iteration_.infeasible();
    if (settled && (!iteration_.isFeasible() || !iteration_.isBalanced())) return iteration_.infeasible();
    if (settled) return {Code::kConverged, ""};
    adapt = choosesStepsNext(move.size, i);
    last_size = move.size;
  }
  return {Code::kNotConverged, "the tensions did not settle at this pose"};
}

// A guide pulley may be why: one that is too small for its rope, or too large for where the rope has to go.
Status InverseSolve::noStiffness() const {
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CableProperties& properties = robot_.cables[i].properties;
    const ForcesAtA forces = iteration_.cables()[i].cable.forces();
    const Status contact = checkContact(properties, forces, tautDeparture(properties, forces));
    if (!contact.ok()) return {contact.code, text("cable '", robot_.cables[i].name, "': ", contact.message)};
  }
  return {Code::kNotConverged, "the tensions did not settle: a cable has no stiffness here"};
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

// Whether the platform stays there.
Status InverseSolve::judge() { return describeStability(robot_, platformStability(robot_, stiffness())); }

const LinearRobot::Stiffness& InverseSolve::stiffness() {
  linear_.start(iteration_.pose());
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const InverseCable& c = iteration_.cables()[i];
    EndPoint end = c.cable.end();
    if (isInextensible(c.cable.model())) {  // a real cable stretches: without that it has no stiffness at all
      const CableProperties& properties = robot_.cables[i].properties;
      const Eigen::Vector2d along = straightFreePart(properties, c.plane.x, c.plane.y).normalized();
      const Eigen::Vector2d force_along(along.x(), -along.y());
      end.jacobian.leftCols<2>() +=
          (c.cable.length() + properties.dead_length) / properties.axial_stiffness * along * force_along.transpose();
    }
    linear_.add(c.plane, forcesAtB(c.cable) * forceJacobian(end).leftCols<2>(), c.cable.horizontalForce(), c.force());
  }
  return linear_.stiffness();
}

bool InverseSolve::follow(const InverseRequest& request) {
  outcome_.iterations = 0;
  request_ = request;
  iteration_.begin(request);
  if (iteration_.attitude().freedoms() > 0) return false;
  if (!predict() || !converge() || !checkBranches().ok()) return false;
  const Status stability = judge();
  if (!stability.ok()) return false;
  if (options_.model == Model::kAuto && !choice_.serve(robot_, iteration_.reached(), options_.accuracy, rungs_)) {
    return false;
  }
  outcome_.status = stability;
  return true;
}

// The cables follow the platform at constant pull.
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

// From a state near the solution.
bool InverseSolve::converge() {
  double last_size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostLinearisations; ++i) {
    ++outcome_.iterations;
    if (!iteration_.lineariseNearby(Steps::kNewWhereDue)) return false;
    iteration_.distributeNearby();
    if (!iteration_.isFeasible() || !iteration_.isBalanced()) return false;
    const InverseIteration::Move move = iteration_.plannedMove();
    if (!move.finite || move.damping < 1.0) return false;
    iteration_.take(move);
    if (hasSettled(move.size, last_size, options_.tolerance)) return true;
    last_size = move.size;
  }
  return false;
}

}  // namespace cdpr_kinetostatics

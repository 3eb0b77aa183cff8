#include "robot/forward_solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cable/iteration_schedule.h"
#include "cable/pulley_cable.h"
#include "cable/text.h"
#include "robot/basin_search.h"
#include "robot/platform_error.h"
#include "robot/platform_stability.h"
#include "robot/platform_statics.h"
#include "robot/robot_gate.h"
#include "robot/solution_assembly.h"
#include "robot/stiffening.h"
#include "robot/straight_forward.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
namespace {

// The search from a seed is left out where Newton's method takes no longer than this and the pose moves no farther.
constexpr int kNearbyIterations = 10;
constexpr double kNearbyShareOfSpan = 0.05;
constexpr double kNearbyAngle = 0.2;  // [rad]

// A search that ended so has found nothing, or an equilibrium that is not kept: another start may lead to the answer.
bool mayBeElsewhere(Code code) {
  return code == Code::kNotConverged || code == Code::kWrongBranch || code == Code::kUnstable;
}

}  // namespace

ForwardSolve::ForwardSolve(const RobotDescription& robot, const RobotSolverOptions& options)
    : robot_(robot), options_(options), newton_(robot) {}

const Status& ForwardSolve::solve(const ForwardRequest& request, Clock::time_point deadline) {
  request_ = request;
  deadline_ = deadline;
  outcome_ = {};
  answer_.reset();
  unstable_.reset();
  contraction_ = kUnknown;
  if (isStraight(options_.model)) {
    solveOnLines(options_.model);
    return outcome_.status;
  }
  const bool choose = options_.model == Model::kAuto;
  if (choose && solveOnLines(Model::kStraightElastic) && isWithin(robot_, *answer_, options_.accuracy)) {
    std::string& message = answer_->report.status.message;
    message = joined(describeChoice(*answer_), message);
    outcome_.status.message = message;
    return outcome_.status;
  }
  answer_.reset();
  if (solveOnCables() && choose) {
    if (!answer_) answer_ = assembled();
    outcome_.status.message = answer_->report.status.message;
  }
  return outcome_.status;
}

bool ForwardSolve::solveOnLines(Model model) {
  RobotSolverOptions options = options_;
  options.model = model;
  options.compute_stiffness = true;
  answer_ = solveStraightForward(robot_, request_, options, deadline_);
  outcome_ = outcomeOf(answer_->report);
  state_.pose = answer_->pose;
  state_.cables.clear();
  rungs_.assign(robot_.cables.size(), model);
  lines_stiffness_ = answer_->stiffness;
  if (!options_.compute_stiffness) answer_->stiffness.setZero();
  if (outcome_.status.code == Code::kUnstable) unstable_ = answer_;
  return outcome_.ok();
}

bool ForwardSolve::solveOnCables() {
  RobotForces start;
  start.pose = request_.seed.value_or(robot_.home);
  if (!took(roughStart(robot_, request_.external_wrench, request_.lengths, deadline_, &start))) return false;
  const RobotForces rough = start;
  if (!reachCatenaries(&start)) return false;
  if (options_.model == Model::kAuto) {
    chooseRungs(start);
    if (mayBeElsewhere(outcome_.status.code)) {
      rungs_.assign(rungs_.size(), Model::kBending);
      refine(start);
    }
  } else {
    rungs_.assign(robot_.cables.size(), options_.model);
    refine(start);
  }
  if (isLost()) stiffenFrom(rough.pose);
  if (isLost()) searchBending(rough);
  return outcome_.ok();
}

// From the springs' pose to the catenaries', by the short way where there is one.
bool ForwardSolve::reachCatenaries(RobotForces* start) {
  const Model rung = startingRung(options_.model);
  return skipSearch(rung, start) ||
         took(searchBasin(robot_, request_.external_wrench, rung, options_.tolerance, deadline_, start));
}

// Newton's method straight from the springs' pose: false, and the start as it was, unless that soon leads to a stable
// pose nearby.
bool ForwardSolve::skipSearch(Model rung, RobotForces* start) {
  RobotForces closed = *start;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot_.cables[i], start->pose);
    const std::optional<ForcesAtA> forces =
        hangingForces(asSeenBy(rung, robot_.cables[i].properties), start->lengths[i], plane.x, plane.y);
    if (!forces) return false;
    closed.forces[i] = *forces;
  }
  rungs_.assign(robot_.cables.size(), rung);
  if (!refine(closed, kNearbyIterations)) return false;
  if ((state_.pose.position - start->pose.position).norm() > kNearbyShareOfSpan * robot_.span()) return false;
  if (state_.pose.orientation.angularDistance(start->pose.orientation) > kNearbyAngle) return false;
  readForces(state_, start);
  return true;
}

// AUTO: models get finer until what they neglect is within the accuracy.
void ForwardSolve::chooseRungs(const RobotForces& start) {
  rungs_ = RungChoice().choose(robot_, start, options_.accuracy, {});
  refine(start);
  while (outcome_.ok()) {
    answer_ = assembled();
    if (isWithin(robot_, *answer_, options_.accuracy) || !refineRungs(&rungs_)) break;
    answer_.reset();
    readForces(state_, &reached_);
    refine(reached_);
  }
}

// Newton's method on the cables' models.
bool ForwardSolve::refine(const RobotForces& start, int max_iterations, double own_shape) {
  startCables(start, own_shape);
  const CoupledOptions options{options_.tolerance, deadline_, max_iterations};
  if (!took(solveCoupled(request_.external_wrench, options, &newton_, &state_))) return false;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    if (state_.cables[i].onBranch()) continue;
    outcome_.status = checkPulleys(robot_, state_.pose);
    if (!outcome_.ok()) return false;
    outcome_.status = {Code::kWrongBranch, "cable '" + robot_.cables[i].name +
                                               "' ended in an equilibrium that is not the sagging one: start from a "
                                               "seed nearer to the platform's pose"};
    return false;
  }
  return judge();
}

// Of the platform's equilibrium that Newton's method has found: its stability, and the freedoms that are open.
bool ForwardSolve::judge() {
  outcome_.status = describeStability(robot_, platformStability(robot_, newton_.stiffness()));
  if (outcome_.status.code == Code::kUnstable) {
    outcome_.status.message += "; no stable pose was found from this seed";
    unstable_ = assembled();
  }
  return outcome_.ok();
}

// A bending cable longer than its chord by the factor own_shape starts from its own problem 2.
void ForwardSolve::startCables(const RobotForces& start, double own_shape) {
  state_.pose = start.pose;
  state_.cables.clear();
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    SaggingCable cable(robot_.cables[i].properties, rungs_[i], options_.tolerance);
    const CablePlane plane = cablePlane(robot_.cables[i], state_.pose);
    bool started = false;
    if (isBending(rungs_[i]) &&
        start.lengths[i] > own_shape * straightRope(robot_.cables[i].properties, plane.x, plane.y).length()) {
      started = cable.startBetween(start.lengths[i], plane.x, plane.y, {options_.tolerance, deadline_}).ok();
    }
    if (!started) cable.start(start.lengths[i], start.forces[i]);
    state_.cables.push_back(std::move(cable));
  }
}

// With bending cables, Newton's method from the catenaries has found nothing, or an equilibrium that is not kept.
bool ForwardSolve::isLost() const { return isBending(rungs_.front()) && mayBeElsewhere(outcome_.status.code); }

void ForwardSolve::stiffenFrom(const Pose& pose) {
  const SearchOutcome before = outcome_;
  state_.pose = pose;
  took(stiffen(robot_, request_.external_wrench, request_.lengths, rungs_, {options_.tolerance, deadline_}, &newton_,
               &state_));
  // That nothing was found on this way says less than that the other one led to a wrong equilibrium.
  if (before.status.code != Code::kNotConverged && outcome_.status.code == Code::kNotConverged) goBackTo(before);
}

// The trust region on the blocks of bending cables: they push where catenaries cannot. Slow, but it finds poses that
// no other way leads to.
void ForwardSolve::searchBending(RobotForces start) {
  const SearchOutcome before = outcome_;
  const bool found =
      took(searchBasin(robot_, request_.external_wrench, rungs_.front(), options_.tolerance, deadline_, &start)) &&
      refine(start, CoupledOptions().max_iterations, 0.0);
  if (!found) goBackTo(before);
}

bool ForwardSolve::took(const SearchOutcome& stage) {
  const int before = outcome_.iterations;
  outcome_ = stage;
  outcome_.iterations += before;
  return outcome_.ok();
}

// What an earlier stage found says more; the work since then counts.
void ForwardSolve::goBackTo(const SearchOutcome& stage) {
  outcome_.status = stage.status;
  outcome_.residuals = stage.residuals;
}

RobotSolution ForwardSolve::assembled() const {
  RobotSolution solution;
  solution.pose = state_.pose;
  solution.report.status = outcome_.status;
  solution.report.iterations = outcome_.iterations;
  assemble(robot_, request_.external_wrench,
           describeCables(robot_, state_.pose, state_.cables, options_.profile_points), &solution);
  if (options_.model == Model::kAuto) {
    solution.report.status.message = joined(describeChoice(solution), solution.report.status.message);
  }
  if (options_.compute_stiffness) solution.stiffness = newton_.stiffness();
  return solution;
}

RobotSolution ForwardSolve::solution() const {
  if (!outcome_.ok() && outcome_.status.code != Code::kUnstable) return failedRobot(options_.model, outcome_);
  RobotSolution solution = !outcome_.ok() ? *unstable_ : answer_ ? *answer_ : assembled();
  solution.report.iterations = outcome_.iterations;
  return onLines() ? solution : verified(std::move(solution));
}

// Straight lines are verified where they are solved.
RobotSolution ForwardSolve::verified(RobotSolution solution) const {
  const Status verdict = verdictOf(robot_, solution, request_.external_wrench, options_.tolerance);
  if (verdict.ok()) return solution;
  solution.report.status = verdict;
  return failedRobot(options_.model, outcomeOf(solution.report));
}

double ForwardSolve::tension(std::size_t i) const {
  return onLines() ? answer_->cables[i].cable.tension_a : state_.cables[i].tensionA();
}

const Eigen::Matrix<double, 6, 6>& ForwardSolve::stiffness() const {
  return onLines() ? lines_stiffness_ : newton_.stiffness();
}

}  // namespace cdpr_kinetostatics

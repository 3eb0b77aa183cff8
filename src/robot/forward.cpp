#include "cdpr_kinetostatics/robot/forward.h"

#include <cmath>
#include <optional>

#include "cable/catenary.h"
#include "cable/tautness.h"
#include "robot/basin_search.h"
#include "robot/coupled_newton.h"
#include "robot/platform_error.h"
#include "robot/platform_statics.h"
#include "robot/robot_checks.h"
#include "robot/rung_choice.h"
#include "robot/solution_assembly.h"
#include "robot/stiffening.h"
#include "robot/straight_forward.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

// The search from a seed is left out where Newton's method takes no longer than this and the pose moves no farther.
constexpr int kNearbyIterations = 10;
constexpr double kNearbyShareOfSpan = 0.05;
constexpr double kNearbyAngle = 0.2;  // [rad]

class ForwardSolve {
 public:
  ForwardSolve(const RobotDescription& robot, const ForwardRequest& request, const RobotSolverOptions& options,
               Clock::time_point deadline)
      : robot_(robot), request_(request), options_(options), deadline_(deadline) {}

  RobotSolution run() {
    RobotForces start;
    start.pose = request_.seed.value_or(robot_.home);
    const bool choose = options_.model == Model::kAuto;
    if (choose) {
      const RobotSolution lines = onLines();
      if (lines.report.status.ok() && isWithin(robot_, lines, options_.accuracy)) return lines;
    }
    Status status = roughStart(robot_, request_.external_wrench, request_.lengths, deadline_, &start, &iterations_);
    if (!status.ok()) return refusedRobot(options_.model, status);
    const RobotForces rough = start;
    const Model rung = startingRung(options_.model);
    if (!skipSearch(rung, &start)) {
      status = searchBasin(robot_, request_.external_wrench, rung, options_.tolerance, deadline_, &start, &iterations_);
      if (!status.ok()) return refusedRobot(options_.model, status);
    }
    rungs_ = choose ? RungChoice().choose(robot_, start, options_.accuracy, {})
                    : std::vector<Model>(robot_.cables.size(), options_.model);
    status = refine(start);
    while (choose && status.ok()) {
      const RobotSolution found = solution();
      if (isWithin(robot_, found, options_.accuracy) || !refineRungs(&rungs_)) return found;
      status = refine(reached());
    }
    if (choose && (status.code == Code::kNotConverged || status.code == Code::kWrongBranch)) {
      rungs_.assign(rungs_.size(), Model::kBending);
      status = refine(start);
    }
    if (isLost(status)) {
      const Status stiffened = stiffenFrom(rough.pose);
      // That nothing was found on this way says less than that the other one led to a wrong equilibrium.
      if (status.code == Code::kNotConverged || stiffened.code != Code::kNotConverged) status = stiffened;
    }
    if (isLost(status)) {
      const Status searched = searchBending(rough);
      if (searched.ok()) status = searched;
    }
    if (!status.ok()) return refusedRobot(options_.model, status);
    return solution();
  }

 private:
  RobotSolution onLines() {
    RobotSolverOptions options = options_;
    options.model = Model::kStraightElastic;
    RobotSolution lines = solveStraightForward(robot_, request_, options, deadline_);
    iterations_ += lines.report.iterations;
    return lines;
  }

  // Newton's method straight from the springs' pose: false, and the start as it was, unless that soon leads to a stable
  // pose nearby.
  bool skipSearch(Model rung, RobotForces* start) {
    RobotForces closed = *start;
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      const CablePlane plane = cablePlane(robot_.cables[i], start->pose);
      const std::optional<ForcesAtA> forces =
          catenaryForces(asSeenBy(rung, robot_.cables[i].properties), start->lengths[i], plane.x, plane.y);
      if (!forces) return false;
      closed.forces[i] = *forces;
    }
    rungs_.assign(robot_.cables.size(), rung);
    if (!refine(closed, kNearbyIterations).ok()) return false;
    if ((state_.pose.position - start->pose.position).norm() > kNearbyShareOfSpan * robot_.span()) return false;
    if (state_.pose.orientation.angularDistance(start->pose.orientation) > kNearbyAngle) return false;
    *start = reached();
    return true;
  }

  RobotForces reached() const {
    RobotForces forces;
    readForces(state_, &forces);
    return forces;
  }

  // Newton's method on the cables' rungs. A bending cable longer than its chord by the factor own_shape starts from its
  // own problem 2.
  Status refine(const RobotForces& start, int max_iterations = CoupledOptions().max_iterations,
                double own_shape = kHangingExcess) {
    state_.pose = start.pose;
    state_.cables.clear();
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      SaggingCable cable(robot_.cables[i].properties, rungs_[i], options_.tolerance);
      const CablePlane plane = cablePlane(robot_.cables[i], state_.pose);
      bool started = false;
      if (isBending(rungs_[i]) && start.lengths[i] > own_shape * std::hypot(plane.x, plane.y)) {
        started = cable.startBetween(start.lengths[i], plane.x, plane.y, {options_.tolerance, deadline_}).ok();
      }
      if (!started) cable.start(start.lengths[i], start.forces[i]);
      state_.cables.push_back(std::move(cable));
    }
    outcome_ = solveCoupled(robot_, request_.external_wrench, {options_.tolerance, deadline_, max_iterations}, &state_);
    iterations_ += outcome_.iterations;
    if (!outcome_.status.ok()) return outcome_.status;
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      if (state_.cables[i].onBranch()) continue;
      return {Code::kWrongBranch, "cable '" + robot_.cables[i].name +
                                      "' ended in an equilibrium that is not the sagging one: start from a seed "
                                      "nearer to the platform's pose"};
    }
    if (!isStable(robot_, outcome_.stiffness)) {
      return {Code::kWrongBranch,
              "the platform's pose found is an unstable equilibrium: start from a seed nearer to the expected pose"};
    }
    return outcome_.status;
  }

  // With bending cables, Newton's method from the catenaries has found nothing, or an equilibrium that is not kept.
  bool isLost(const Status& status) const {
    return isBending(rungs_.front()) && (status.code == Code::kNotConverged || status.code == Code::kWrongBranch);
  }

  // The trust region on the blocks of bending cables: they push where catenaries cannot. Slow, but it finds poses that
  // no other way leads to.
  Status searchBending(RobotForces start) {
    const Status status = searchBasin(robot_, request_.external_wrench, rungs_.front(), options_.tolerance, deadline_,
                                      &start, &iterations_);
    return status.ok() ? refine(start, CoupledOptions().max_iterations, 0.0) : status;
  }

  Status stiffenFrom(const Pose& pose) {
    state_.pose = pose;
    outcome_ =
        stiffen(robot_, request_.external_wrench, request_.lengths, rungs_, {options_.tolerance, deadline_}, &state_);
    iterations_ += outcome_.iterations;
    return outcome_.status;
  }

  RobotSolution solution() const {
    RobotSolution solution;
    solution.pose = state_.pose;
    solution.report.status = outcome_.status;
    solution.report.iterations = iterations_;
    assemble(robot_, request_.external_wrench,
             describeCables(robot_, state_.pose, state_.cables, options_.profile_points), &solution);
    if (options_.compute_stiffness) solution.stiffness = outcome_.stiffness;
    return solution;
  }

  const RobotDescription& robot_;
  const ForwardRequest& request_;
  const RobotSolverOptions& options_;
  const Clock::time_point deadline_;
  std::vector<Model> rungs_;  // in the robot's order
  CoupledState state_;
  CoupledOutcome outcome_;
  int iterations_ = 0;
};

}  // namespace

RobotSolution solveForward(const RobotDescription& robot, const ForwardRequest& request,
                           const RobotSolverOptions& options) {
  const Clock::time_point begin = Clock::now();
  for (const Status& check :
       {checkRobotOptions(options), checkLengths(robot, request.lengths), checkWrench(robot, request.external_wrench),
        request.seed ? checkPose("seed", *request.seed) : checkPose("home", robot.home)}) {
    if (!check.ok()) return refusedRobot(options.model, check);
  }
  const Clock::time_point deadline = deadlineAfter(options.timeout);
  RobotSolution solution = isStraight(options.model) ? solveStraightForward(robot, request, options, deadline)
                                                     : ForwardSolve(robot, request, options, deadline).run();
  if (options.model == Model::kAuto && solution.report.status.ok()) {
    solution.report.status.message = describeChoice(solution);
  }
  solution.report.solve_time = std::chrono::duration<double>(Clock::now() - begin).count();
  return solution;
}

}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/estimation/pose_estimator.h"

#include <algorithm>
#include <utility>

#include "estimation/cold_start.h"
#include "estimation/estimate_error.h"
#include "estimation/estimate_report.h"
#include "estimation/fault_search.h"
#include "estimation/plausibility.h"
#include "estimation/rival_faults.h"
#include "estimation/variance_window.h"
#include "robot/robot_checks.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

Status checkMeasurements(const RobotDescription& robot, const CableMeasurements& measurements) {
  Status status = firstRefusal(checkCount("lengths", measurements.lengths.size(), robot),
                               checkCount("tensions", measurements.tensions.size(), robot));
  for (std::size_t i = 0; status.ok() && i < robot.cables.size(); ++i) {
    const std::string& cable = robot.cables[i].name;
    const double length = measurements.lengths[i].value_or(1.0);
    const double tension = measurements.tensions[i].value_or(1.0);
    status = firstRefusal(checkLength({"lengths", i, cable}, length),
                          checkWithin({"tensions", i, cable}, tension, kLargestForce, "N"));
  }
  return status;
}

Selection available(const RobotDescription& robot, const EstimatorOptions& options,
                    const CableMeasurements& measurements) {
  Selection selection;
  bool any_tension = false;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    selection.lengths.push_back(measurements.lengths[i].has_value());
    selection.tensions.push_back(measurements.tensions[i].has_value());
    any_tension |= measurements.tensions[i].has_value();
  }
  // Lengths alone fix no pose: the load then stands in for the tensions.
  const bool load = options.known_load || !any_tension;
  for (int k = 0; k < robot.freedoms(); ++k) selection.load(k) = load;
  return selection;
}

// AUTO: adjusts anew on finer rungs while those in use neglect too much, and judges faults anew on the last; kept are
// those of the last estimate. Returns the rungs for the next one, which may be coarser.
std::vector<Model> adaptRungs(MeasuredRobot* measured, Candidate* candidate, const std::vector<Model>& kept) {
  std::vector<Model> wanted;
  bool judged = true;
  for (std::size_t attempt = 0; attempt < 2 * kAutoRungs.size() && candidate->adjusted.status.ok(); ++attempt) {
    wanted = RungChoice().choose(rungEffects(*measured, candidate, kept), measured->options.accuracy, kept);
    bool finer = false;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      finer = finer || wanted[i] > measured->rungs[i];
      measured->rungs[i] = std::max(measured->rungs[i], wanted[i]);
    }
    if (!finer && judged) break;
    const RobotForces at = candidate->adjusted.unknowns;
    *candidate =
        finer ? adjust(*measured, at, candidate->selection) : adjustFrom(*measured, at, leftOut(*measured, *candidate));
    judged = !finer;
  }
  return wanted;
}

// The platform has moved so far since the last message that the last pose says little of this one.
constexpr double kFarMove = 0.05;  // share of the robot's span
constexpr double kFarTurn = 0.2;   // [rad]

// Where measurements are left out, in one message after the other the same ones, a fresh start competes in one of so
// many messages: it takes many times as long as following, and a wrong pose must not last for ten.
constexpr int kFreshStart = 5;

bool isTurned(const Pose& from, const Pose& to) { return to.orientation.angularDistance(from.orientation) > kFarTurn; }

bool isFar(const RobotDescription& robot, const Pose& from, const Pose& to) {
  return (to.position - from.position).norm() > kFarMove * robot.span() || isTurned(from, to);
}

bool isSameAnswer(const MeasuredRobot& measured, const Candidate& a, const Candidate& b) {
  return a.adjusted.status.ok() && b.adjusted.status.ok() && isSame(leftOut(measured, a), leftOut(measured, b)) &&
         !isFar(measured.robot, a.adjusted.unknowns.pose, b.adjusted.unknowns.pose);
}

bool isSame(const Pose& a, const Pose& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

}  // namespace

// The estimator's memory: what it found last, and where it looks first.
class PoseEstimator::Tracker {
 public:
  Tracker(const RobotDescription& robot, const EstimatorOptions& options)
      : robot_(robot), robot_check_(checkRobot(robot)), options_(options), seed_(robot.home), near_(robot.home) {}

  Estimate update(const CableMeasurements& measurements);
  void reset(const Pose& seed);

  const RobotDescription& robot() const { return robot_; }

 private:
  struct Found {
    Candidate best;
    int iterations = 0;
    bool warm_started = false;
    std::vector<Model> rungs;   // of the best
    std::vector<Model> wanted;  // AUTO: rungs for the next message
    bool followed = false;      // no fresh start competed
  };

  Estimate solve(MeasuredRobot* measured);
  Estimate judged(const MeasuredRobot& measured, Candidate* best);
  Found find(MeasuredRobot* measured) const;
  Found fromLast(MeasuredRobot* measured) const;
  Found afresh(MeasuredRobot* measured, const Pose& seed) const;
  void compete(MeasuredRobot* measured, const Pose& seed, bool wins_ties, Found* found) const;

  const RobotDescription& robot_;
  const Status robot_check_;
  const EstimatorOptions options_;
  Pose seed_;
  Pose near_;  // last pose, or the seed
  std::optional<RobotForces> last_;
  Selection left_out_;  // by the last estimate
  int followed_ = 0;    // messages since a fresh start competed
  VarianceWindow window_;
  std::vector<Model> rungs_;  // AUTO: those in use; empty at first
};

Estimate PoseEstimator::Tracker::update(const CableMeasurements& measurements) {
  const Clock::time_point begin = Clock::now();
  Status check = firstRefusal(robot_check_, checkMeasurements(robot_, measurements));
  if (check.ok()) check = checkPlausible(robot_, options_, measurements);
  Estimate estimate;
  if (check.ok()) {
    const Clock::time_point deadline = deadlineAfter(options_.timeout);
    MeasuredRobot measured{robot_, options_, measurements, deadline, available(robot_, options_, measurements), {}};
    estimate = solve(&measured);
  } else {
    estimate.solution = refusedRobot(options_.model, check);
  }
  estimate.solution.report.solve_time = std::chrono::duration<double>(Clock::now() - begin).count();
  return estimate;
}

Estimate PoseEstimator::Tracker::solve(MeasuredRobot* measured) {
  Found found = find(measured);
  measured->rungs = found.rungs;
  followed_ = found.followed ? followed_ + 1 : 0;
  Status status = found.best.adjusted.status;
  if (Clock::now() > measured->deadline) {
    status = {Code::kTimedOut, "the time allowed ran out before it was certain which pose explains the measurements"};
  }
  Estimate estimate;
  if (status.ok()) {
    estimate = judged(*measured, &found.best);
    estimate.warm_started = found.warm_started;
    last_ = found.best.adjusted.unknowns;
    left_out_ = leftOut(*measured, found.best);
    rungs_ = found.wanted;
    near_ = last_->pose;
  } else {
    estimate.solution = refusedRobot(options_.model, status);
    // One step back at a time: another start may need less time.
    if (!last_ && isSame(near_, seed_)) seed_ = robot_.home;
    if (!last_) near_ = seed_;
    last_.reset();
    rungs_.clear();
  }
  estimate.solution.report.iterations = found.iterations;
  return estimate;
}

// Faults are judged by the deviations given, else a drum that slips slowly would never be one. What they leave is
// weighed by the deviations that it shows.
Estimate PoseEstimator::Tracker::judged(const MeasuredRobot& measured, Candidate* best) {
  std::vector<Candidate> rivals = rivalsOf(measured, best);
  window_.add(*best);
  const DeviationFactors factors = window_.factors(*best);
  const EstimatorOptions options = widened(options_, factors);
  const MeasuredRobot believed{robot_,        options, measured.measurements, measured.deadline, measured.available,
                               measured.rungs};
  if (isWider(factors)) {
    const auto again = [&](Candidate* candidate) {
      Candidate wide = adjust(believed, candidate->adjusted.unknowns, candidate->selection);
      if (wide.adjusted.status.ok()) *candidate = std::move(wide);
    };
    again(best);
    for (Candidate& rival : rivals) again(&rival);
  }
  const std::vector<Candidate> unproven = unprovenFaults(believed, *best);
  Estimate estimate;
  if (Clock::now() > measured.deadline) {
    estimate.solution = refusedRobot(
        options_.model,
        {Code::kTimedOut, "the time allowed ran out before it was certain which measurements may be at fault"});
    return estimate;
  }
  estimate = report(believed, best, rivals, unproven);
  estimate.deviation_factors = factors;
  return estimate;
}

// The last estimate is only one of the starts. Unless its answer is beyond doubt, that of an estimator without a past
// competes, at the latest with the fifth message, and the measurements alone decide between them. Where they do not,
// the past counts if the answer continues it: a short move, with the same measurements at fault.
PoseEstimator::Tracker::Found PoseEstimator::Tracker::find(MeasuredRobot* measured) const {
  Found found;
  bool continues = false;
  if (last_) {
    found = fromLast(measured);
    const bool near = found.best.adjusted.status.ok() && !isFar(robot_, last_->pose, found.best.adjusted.unknowns.pose);
    if (near && isBeyondDoubt(*measured, found.best)) return found;
    continues = near && isSame(leftOut(*measured, found.best), left_out_);
    if (continues && isNoise(found.best) && followed_ + 1 < kFreshStart) {
      found.followed = true;
      return found;
    }
  }
  compete(measured, seed_, !continues, &found);
  if (!isSame(robot_.home, seed_) && !isBeyondDoubt(*measured, found.best)) {
    compete(measured, robot_.home, false, &found);
  }
  if (!isSame(near_, seed_) && !isNoise(found.best)) compete(measured, near_, false, &found);
  // A start far away may end on its head, where some of the measurements fit.
  const Pose at = found.best.adjusted.unknowns.pose;
  if (found.best.adjusted.status.ok() && isTurned(seed_, at) && !isBeyondDoubt(*measured, found.best)) {
    compete(measured, {at.position, seed_.orientation}, false, &found);
  }
  return found;
}

void PoseEstimator::Tracker::compete(MeasuredRobot* measured, const Pose& seed, bool wins_ties, Found* found) const {
  Found fresh = afresh(measured, seed);
  const int iterations = found->iterations + fresh.iterations;
  const bool better =
      wins_ties ? !isBetter(*measured, found->best, fresh.best) : isBetter(*measured, fresh.best, found->best);
  if (better) {
    fresh.warm_started = found->warm_started && isSameAnswer(*measured, found->best, fresh.best);
    *found = std::move(fresh);
  }
  found->iterations = iterations;
}

PoseEstimator::Tracker::Found PoseEstimator::Tracker::fromLast(MeasuredRobot* measured) const {
  const bool choose = options_.model == Model::kAuto;
  measured->rungs = rungs_;
  if (rungs_.empty()) measured->rungs.assign(robot_.cables.size(), choose ? Model::kCatenary : options_.model);
  Found found;
  found.best = adjustFrom(*measured, *last_, left_out_);
  found.iterations = found.best.adjusted.iterations;
  found.warm_started = true;
  if (choose) found.wanted = adaptRungs(measured, &found.best, rungs_);
  found.rungs = measured->rungs;
  return found;
}

// AUTO starts on catenaries and goes on to what the measurements need; where that finds no pose, every cable bends.
PoseEstimator::Tracker::Found PoseEstimator::Tracker::afresh(MeasuredRobot* measured, const Pose& seed) const {
  const bool choose = options_.model == Model::kAuto;
  Found found;
  for (const Model model : {choose ? Model::kCatenary : options_.model, Model::kBending}) {
    measured->rungs.assign(robot_.cables.size(), model);
    found.best = leaveOutFaults(*measured, coldStart(*measured, seed, &found.iterations), measured->available);
    found.iterations += found.best.adjusted.iterations;
    if (choose) found.wanted = adaptRungs(measured, &found.best, {});
    if (!choose || found.best.adjusted.status.ok()) break;
  }
  found.rungs = measured->rungs;
  return found;
}

void PoseEstimator::Tracker::reset(const Pose& seed) {
  last_.reset();
  rungs_.clear();
  followed_ = 0;
  window_.clear();
  seed_ = near_ = seed;
}

PoseEstimator::PoseEstimator(const RobotDescription& robot, const EstimatorOptions& options)
    : tracker_(std::make_unique<Tracker>(robot, options)) {}
PoseEstimator::PoseEstimator(PoseEstimator&& other) noexcept = default;
PoseEstimator::~PoseEstimator() = default;

Estimate PoseEstimator::update(const CableMeasurements& measurements) { return tracker_->update(measurements); }

void PoseEstimator::reset() { setPose(tracker_->robot().home); }

void PoseEstimator::setPose(const Pose& seed) { tracker_->reset(seed); }

}  // namespace cdpr_kinetostatics

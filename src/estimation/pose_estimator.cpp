#include "cdpr_kinetostatics/estimation/pose_estimator.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "cdpr_kinetostatics/robot/solution_assembly.h"
#include "cold_start.h"
#include "estimate_report.h"
#include "fault_search.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kMaxLength = 1e6;    // [m]
constexpr double kMaxTension = 1e12;  // [N]

Status checkMeasurements(const RobotDescription& robot, const CableMeasurements& measurements) {
  const std::size_t n = robot.cables.size();
  std::ostringstream text;
  if (measurements.lengths.size() != n || measurements.tensions.size() != n) {
    text << measurements.lengths.size() << " lengths and " << measurements.tensions.size() << " tensions for " << n
         << " cables";
    return {Code::kInvalidInput, text.str()};
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double length = measurements.lengths[i].value_or(1.0);
    const double tension = measurements.tensions[i].value_or(1.0);
    if (length > 0.0 && length <= kMaxLength && std::abs(tension) <= kMaxTension) continue;
    text << "cable '" << robot.cables[i].name << "': length " << length << " m must be positive and at most "
         << kMaxLength << " m, tension " << tension << " N within " << kMaxTension << " N of zero";
    return {Code::kInvalidInput, text.str()};
  }
  return {Code::kConverged, ""};
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

}  // namespace

PoseEstimator::PoseEstimator(const RobotDescription& robot, const EstimatorOptions& options)
    : robot_(robot), options_(options), seed_(robot.home), near_(robot.home) {}

Estimate PoseEstimator::update(const CableMeasurements& measurements) {
  const Clock::time_point begin = Clock::now();
  const Status check = checkMeasurements(robot_, measurements);
  Estimate estimate;
  if (check.ok()) {
    const Clock::time_point deadline = begin + std::chrono::duration_cast<Clock::duration>(options_.timeout);
    estimate = solve({robot_, options_, measurements, deadline, available(robot_, options_, measurements)});
  } else {
    estimate.solution = refusedRobot(options_.model, check);
  }
  estimate.solution.report.solve_time = std::chrono::duration<double>(Clock::now() - begin).count();
  return estimate;
}

Estimate PoseEstimator::solve(const MeasuredRobot& measured) {
  Candidate best;
  bool warm_started = false;
  int iterations = 0;
  if (last_) {
    best = adjustFrom(measured, *last_, left_out_);
    warm_started = true;
    iterations = best.adjusted.iterations;
  }
  const bool moved = near_.position != seed_.position || near_.orientation.coeffs() != seed_.orientation.coeffs();
  for (const Pose* seed : {&near_, &seed_}) {
    if (isTrusted(measured, best) || (seed == &seed_ && !moved)) break;
    Candidate cold = leaveOutFaults(measured, coldStart(measured, *seed, &iterations), measured.available);
    iterations += cold.adjusted.iterations;
    if (!isBetter(measured, cold, best)) continue;
    best = std::move(cold);
    warm_started = false;
  }
  Status status = best.adjusted.status;
  if (Clock::now() > measured.deadline) {
    status = {Code::kTimedOut, "the time allowed ran out before it was certain which pose explains the measurements"};
  }
  Estimate estimate;
  if (status.ok()) {
    estimate = report(measured, best);
    estimate.warm_started = warm_started;
    last_ = best.adjusted.unknowns;
    left_out_ = leftOut(measured, best);
    near_ = last_->pose;
  } else {
    estimate.solution = refusedRobot(options_.model, status);
    if (!last_) near_ = seed_;  // one step back at a time: another start may need less time
    last_.reset();
  }
  estimate.solution.report.iterations = iterations;
  return estimate;
}

void PoseEstimator::reset() { setPose(robot_.home); }

void PoseEstimator::setPose(const Pose& seed) {
  last_.reset();
  seed_ = near_ = seed;
}

}  // namespace cdpr_kinetostatics

#include "cdpr_kinetostatics/estimation/pose_estimator.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "cdpr_kinetostatics/robot/solution_assembly.h"
#include "cold_start.h"
#include "estimate_report.h"
#include "fault_search.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

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
    if (length > 0.0 && length <= 1e6 && tension >= 0.0 && tension <= 1e12) continue;
    text << "cable '" << robot.cables[i].name << "': length " << length << " m must be positive, tension " << tension
         << " N zero or positive";
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
    : robot_(robot), options_(options), seed_(robot.home) {}

Estimate PoseEstimator::update(const CableMeasurements& measurements) {
  const Clock::time_point begin = Clock::now();
  const Status check = checkMeasurements(robot_, measurements);
  Estimate estimate;
  if (!check.ok()) {
    estimate.solution = refusedRobot(options_.model, check);
    return estimate;
  }
  const Clock::time_point deadline = begin + std::chrono::duration_cast<Clock::duration>(options_.timeout);
  const MeasuredRobot measured{robot_, options_, measurements, deadline, available(robot_, options_, measurements)};
  Candidate best;
  const bool warm = last_.has_value();
  if (warm) {
    Selection selection = measured.available;
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      if (last_length_outlier_[i]) selection.lengths[i] = false;
      if (last_tension_outlier_[i]) selection.tensions[i] = false;
    }
    leaveOutJumps(measured, *last_, &selection);
    best = leaveOutFaults(measured, *last_, selection);
    if (best.adjusted.status.ok()) takeBack(measured, *last_, &best);
  }
  estimate.warm_started = warm;
  int iterations = best.adjusted.iterations;
  if (!warm || !isGood(best.adjusted, options_.outlier_threshold)) {
    const RobotForces start = coldStart(measured, warm ? last_->pose : seed_, &iterations);
    const Candidate cold = leaveOutFaults(measured, start, measured.available);
    iterations += cold.adjusted.iterations;
    const bool better =
        !best.adjusted.status.ok() ||
        (cold.adjusted.status.ok() && (cold.adjusted.redundancy > best.adjusted.redundancy ||
                                       cold.adjusted.weighted_squares < best.adjusted.weighted_squares));
    if (better) {
      best = cold;
      estimate.warm_started = false;
    }
  }
  if (!best.adjusted.status.ok()) {
    last_.reset();
    estimate.solution = refusedRobot(options_.model, best.adjusted.status);
    return estimate;
  }
  const bool warm_started = estimate.warm_started;
  estimate = report(measured, best);
  estimate.warm_started = warm_started;
  estimate.solution.report.iterations = iterations;
  last_ = best.adjusted.unknowns;
  last_length_outlier_ = estimate.length_outlier;
  last_tension_outlier_ = estimate.tension_outlier;
  estimate.solution.report.solve_time = std::chrono::duration<double>(Clock::now() - begin).count();
  return estimate;
}

void PoseEstimator::reset() {
  last_.reset();
  seed_ = robot_.home;
}

void PoseEstimator::setPose(const Pose& seed) {
  last_.reset();
  seed_ = seed;
}

}  // namespace cdpr_kinetostatics

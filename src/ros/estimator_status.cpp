#include "ros/estimator_status.h"

#include <algorithm>
#include <cmath>

#include "estimation/fault_names.h"

namespace cdpr_kinetostatics {

void EstimatorStatus::add(const Estimate& estimate, const KinetostaticState& state) {
  last = state.report;
  ++solves;
  ++recent_solves;
  recent_solve_time += last.solve_time;
  largest_solve_time = std::max(largest_solve_time, last.solve_time);
  if (last.code != SolveReport::CONVERGED) {
    ++failures;
    ++recent_failures;
    last_failure = last.message;
    return;
  }
  if (!last.warm_started) ++cold_starts;
  outliers = faultNames(estimate.solution, estimate.length_outlier, estimate.tension_outlier, estimate.load_outlier);
  suspects = faultNames(estimate.solution, estimate.length_suspect, estimate.tension_suspect, estimate.load_suspect);
  deviation_factors = estimate.deviation_factors;
  unobservable_directions = estimate.unobservable_directions;
  redundancy = estimate.redundancy;
  weighted_squares = estimate.weighted_squares;
  position_stddev = std::sqrt(estimate.covariance.diagonal().head<3>().maxCoeff());
  rotation_stddev = std::sqrt(estimate.covariance.diagonal().tail<3>().maxCoeff());
  const Eigen::Array<double, 6, 1> load = estimate.load_covariance.diagonal();
  const Eigen::Array<double, 6, 1> known = estimate.load_unknown.select(0.0, load.sqrt());
  force_stddev = known.head<3>().maxCoeff();
  torque_stddev = known.tail<3>().maxCoeff();
  unknown_load_components = static_cast<int>(estimate.load_unknown.count());
}

void EstimatorStatus::startAnew() {
  recent_solves = recent_failures = 0;
  recent_solve_time = largest_solve_time = 0.0;
}

}  // namespace cdpr_kinetostatics

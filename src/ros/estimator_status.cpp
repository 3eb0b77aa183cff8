#include "ros/estimator_status.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {

namespace {

std::vector<std::string> outliersOf(const Estimate& estimate) {
  static const char* const kComponents[] = {"force x", "force y", "force z", "torque x", "torque y", "torque z"};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < estimate.length_outlier.size(); ++i) {
    const std::string& cable = estimate.solution.cables[i].name;
    if (estimate.length_outlier[i]) names.push_back("length of " + cable);
    if (estimate.tension_outlier[i]) names.push_back("tension of " + cable);
  }
  for (Eigen::Index k = 0; k < 6; ++k) {
    if (estimate.load_outlier(k)) names.push_back(std::string("known load, ") + kComponents[k]);
  }
  return names;
}

}  // namespace

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
  outliers = outliersOf(estimate);
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

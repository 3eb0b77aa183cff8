#include "estimation/fault_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace cdpr_kinetostatics {
namespace {

// A measurement that jumps this many times farther than most others since the last estimate is not trusted at first.
constexpr double kJump = 10.0;

// A sum of squares no more than so many standard deviations above its mean is what noise makes, if so many redundant
// measurements say so: fewer agree by chance.
constexpr double kPlausible = 1.0;
constexpr int kWitnesses = 4;

// A sum of squares more than so many standard deviations above its mean is not noise (one in 1e5 for 8 redundant
// measurements).
constexpr double kImprobable = 5.0;

// Answers whose sums of squares differ by less are equally good. What AUTO's models may neglect changes them by less.
constexpr double kIndistinct = 0.1;

bool disagree(const std::vector<Observation>& observations, double threshold) {
  return std::any_of(observations.begin(), observations.end(),
                     [&](const Observation& o) { return statistic(o) > threshold; });
}

std::vector<Observation> worstFirst(std::vector<Observation> observations) {
  std::stable_sort(observations.begin(), observations.end(),
                   [](const Observation& l, const Observation& r) { return statistic(l) > statistic(r); });
  return observations;
}

// Only noise is left.
bool isPlausible(const Adjusted& adjusted) {
  const double mean = adjusted.redundancy;
  return adjusted.redundancy >= kWitnesses && adjusted.weighted_squares < mean + kPlausible * std::sqrt(2.0 * mean);
}

// Largest jump that passes, with the median of all jumps as a measure of how far the platform has moved.
double jumpLimit(std::vector<double> jumps, double stddev, double threshold) {
  std::nth_element(jumps.begin(), jumps.begin() + jumps.size() / 2, jumps.end());
  return kJump * std::max(jumps[jumps.size() / 2], stddev) + threshold * stddev;
}

void leaveOutJumps(const MeasuredRobot& measured, const RobotForces& last, Selection* selection) {
  const EstimatorOptions& options = measured.options;
  std::vector<double> lengths, tensions;
  for (std::size_t i = 0; i < measured.robot.cables.size(); ++i) {
    const double tension = std::hypot(last.forces[i].horizontal, last.forces[i].vertical);
    lengths.push_back(measured.available.lengths[i] ? std::abs(*measured.measurements.lengths[i] - last.lengths[i])
                                                    : 0.0);
    tensions.push_back(measured.available.tensions[i] ? std::abs(*measured.measurements.tensions[i] - tension) : 0.0);
  }
  const double length_limit = jumpLimit(lengths, options.length_stddev, options.outlier_threshold);
  const double tension_limit = jumpLimit(tensions, options.tension_stddev, options.outlier_threshold);
  for (std::size_t i = 0; i < measured.robot.cables.size(); ++i) {
    if (lengths[i] > length_limit) selection->lengths[i] = false;
    if (tensions[i] > tension_limit) selection->tensions[i] = false;
  }
}

void takeBack(const MeasuredRobot& measured, const RobotForces& start, Candidate* candidate) {
  const double threshold = measured.options.outlier_threshold;
  const auto attempt = [&](const Selection& with) {
    Candidate trial = adjust(measured, start, with);
    if (trial.adjusted.status.ok() &&
        trial.adjusted.weighted_squares < candidate->adjusted.weighted_squares + threshold * threshold &&
        !disagree(trial.adjusted.observations, threshold)) {
      *candidate = std::move(trial);
    }
  };
  for (std::size_t i = 0; i < measured.robot.cables.size(); ++i) {
    Selection with = candidate->selection;
    with.lengths[i] = measured.available.lengths[i];
    if (with.lengths[i] != candidate->selection.lengths[i]) attempt(with);
    with = candidate->selection;
    with.tensions[i] = measured.available.tensions[i];
    if (with.tensions[i] != candidate->selection.tensions[i]) attempt(with);
  }
  for (Eigen::Index k = 0; k < measured.available.load.size(); ++k) {
    Selection with = candidate->selection;
    with.load(k) = measured.available.load(k);
    if (with.load(k) != candidate->selection.load(k)) attempt(with);
  }
}

bool explains(const MeasuredRobot& measured, const Candidate& candidate) {
  const Adjusted& adjusted = candidate.adjusted;
  const double threshold = measured.options.outlier_threshold;
  return adjusted.status.ok() && adjusted.weighted_squares < threshold * threshold * std::max(adjusted.redundancy, 1);
}

}  // namespace

double statistic(const Observation& observation) {
  return observation.redundancy >= kTestable ? std::abs(observation.residual) / std::sqrt(observation.redundancy) : 0.0;
}

Candidate leaveOutFaults(const MeasuredRobot& measured, const RobotForces& start, const Selection& selection) {
  Candidate candidate = adjust(measured, start, selection);
  while (candidate.adjusted.status.ok() && candidate.adjusted.redundancy > 0 &&
         disagree(candidate.adjusted.observations, measured.options.outlier_threshold)) {
    std::optional<Candidate> best;
    for (const Observation& suspect : worstFirst(candidate.adjusted.observations)) {
      Selection without = candidate.selection;
      use(suspect, false, &without);
      Candidate trial = adjust(measured, start, without);
      if (!trial.adjusted.status.ok()) continue;
      if (!best || trial.adjusted.weighted_squares < best->adjusted.weighted_squares) best = std::move(trial);
      if (isPlausible(best->adjusted)) break;
    }
    if (!best) break;
    candidate = std::move(*best);
  }
  return candidate;
}

Candidate adjustFrom(const MeasuredRobot& measured, const RobotForces& last, const Selection& left_out) {
  Selection selection = measured.available;
  for (std::size_t i = 0; i < measured.robot.cables.size(); ++i) {
    if (left_out.lengths[i]) selection.lengths[i] = false;
    if (left_out.tensions[i]) selection.tensions[i] = false;
  }
  selection.load = selection.load && !left_out.load;
  leaveOutJumps(measured, last, &selection);
  Candidate candidate = leaveOutFaults(measured, last, selection);
  if (candidate.adjusted.status.ok()) takeBack(measured, last, &candidate);
  return candidate;
}

Selection leftOut(const MeasuredRobot& measured, const Candidate& candidate) {
  Selection left_out;
  for (std::size_t i = 0; i < measured.robot.cables.size(); ++i) {
    left_out.lengths.push_back(measured.available.lengths[i] && !candidate.selection.lengths[i]);
    left_out.tensions.push_back(measured.available.tensions[i] && !candidate.selection.tensions[i]);
  }
  left_out.load = measured.available.load && !candidate.selection.load;
  return left_out;
}

bool isNoise(const Candidate& candidate) {
  const Adjusted& adjusted = candidate.adjusted;
  const double mean = adjusted.redundancy;
  return adjusted.status.ok() && adjusted.stable &&
         adjusted.weighted_squares <= mean + kImprobable * (std::sqrt(2.0 * mean) + 1.0);
}

bool isBeyondDoubt(const MeasuredRobot& measured, const Candidate& candidate) {
  return isNoise(candidate) && isSame(candidate.selection, measured.available);
}

void use(const Observation& observation, bool used, Selection* selection) {
  switch (observation.kind) {
    case Observation::Kind::kLength:
      selection->lengths[observation.index] = used;
      break;
    case Observation::Kind::kTension:
      selection->tensions[observation.index] = used;
      break;
    case Observation::Kind::kLoad:
      selection->load(static_cast<Eigen::Index>(observation.index)) = used;
      break;
  }
}

bool isSame(const Selection& a, const Selection& b) {
  return a.lengths == b.lengths && a.tensions == b.tensions && (a.load == b.load).all();
}

// A measurement that is left out must lower the sum of squares by what calls it a fault, threshold^2.
bool isBetter(const MeasuredRobot& measured, const Candidate& a, const Candidate& b) {
  const auto rank = [&](const Candidate& c) {
    const Adjusted& adjusted = c.adjusted;
    const bool tried = adjusted.status.code != Code::kUnset;
    return std::make_tuple(tried, adjusted.status.ok(), explains(measured, c), adjusted.stable);
  };
  const auto cost = [&](const Candidate& c) {
    return c.adjusted.weighted_squares - std::pow(measured.options.outlier_threshold, 2) * c.adjusted.redundancy;
  };
  if (rank(a) != rank(b)) return rank(a) > rank(b);
  return cost(a) < cost(b) - kIndistinct;
}

}  // namespace cdpr_kinetostatics

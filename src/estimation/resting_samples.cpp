#include "estimation/resting_samples.h"

#include <cmath>
#include <numeric>

#include "cable/text.h"

namespace cdpr_kinetostatics {
namespace {

// At rest spread and drift stay within so many of their own standard deviations: beyond, one platform at rest in a
// hundred thousand would be taken for a moving one.
constexpr double kSure = 5.0;

double meanOf(const std::vector<double>& samples, std::size_t from, std::size_t to) {
  return std::accumulate(samples.begin() + static_cast<std::ptrdiff_t>(from),
                         samples.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
         static_cast<double>(to - from);
}

double meanOf(const std::vector<double>& samples) { return meanOf(samples, 0, samples.size()); }

// Standard deviation of the samples.
double spreadOf(const std::vector<double>& samples) {
  const double mean = meanOf(samples);
  double squares = 0.0;
  for (const double sample : samples) squares += (sample - mean) * (sample - mean);
  return std::sqrt(squares / static_cast<double>(samples.size() - 1));
}

// Mean of the later half less that of the earlier one.
double driftOf(const std::vector<double>& samples) {
  const std::size_t half = samples.size() / 2;
  return meanOf(samples, half, samples.size()) - meanOf(samples, 0, half);
}

Status checkCable(const std::vector<double>& samples, const char* what, const std::string& cable, double stddev,
                  const char* unit, const char* parameter) {
  if (samples.size() < RestingSamples::kLeast) {
    return {Code::kInvalidInput,
            text("cable '", cable, "' has ", samples.size(), " samples of its ", what, ": at least ",
                 RestingSamples::kLeast, " are needed. Is the driver running? Give a longer window")};
  }
  const auto n = static_cast<double>(samples.size());
  const double most_spread = stddev * (1.0 + kSure / std::sqrt(2.0 * (n - 1.0)));
  const double most_drift = kSure * stddev * std::sqrt(4.0 / n);
  const double spread = spreadOf(samples);
  const double drift = std::abs(driftOf(samples));
  if (spread <= most_spread && drift <= most_drift) return {Code::kConverged, ""};
  return {Code::kInvalidInput,
          text("the platform is not at rest: the ", what, " of cable '", cable, "' spreads by ", spread, " ", unit,
               " and drifts by ", drift, " ", unit, " within ", samples.size(), " samples, expected at most ",
               most_spread, " and ", most_drift, ": let it come to rest; if it is, ~", parameter, " is too small")};
}

}  // namespace

void RestingSamples::add(const CableMeasurements& measurements) {
  ++count_;
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    if (measurements.lengths[i]) lengths_[i].push_back(*measurements.lengths[i]);
    if (measurements.tensions[i]) tensions_[i].push_back(*measurements.tensions[i]);
  }
}

double RestingSamples::meanLength(std::size_t cable) const { return meanOf(lengths_[cable]); }

double RestingSamples::meanTension(std::size_t cable) const { return meanOf(tensions_[cable]); }

Status RestingSamples::checkRest(const RobotDescription& robot, bool use_tensions, double length_stddev,
                                 double tension_stddev) const {
  Status status{Code::kConverged, ""};
  for (std::size_t i = 0; i < lengths_.size() && status.ok(); ++i) {
    const std::string& name = robot.cables[i].name;
    status = checkCable(lengths_[i], "length", name, length_stddev, "m", "length_stddev");
    if (!status.ok() || !use_tensions) continue;
    status = checkCable(tensions_[i], "tension", name, tension_stddev, "N", "tension_stddev");
  }
  return status;
}

}  // namespace cdpr_kinetostatics

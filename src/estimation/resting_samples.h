// Measurements of a platform that should be at rest: their averages, and whether it was.
#pragma once

#include <vector>

#include "cdpr_kinetostatics/cable/report.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"

namespace cdpr_kinetostatics {

class RestingSamples {
 public:
  // Of both halves of what was measured, so many that a drift shows.
  static constexpr std::size_t kLeast = 4;

  explicit RestingSamples(std::size_t cables) : lengths_(cables), tensions_(cables) {}

  void add(const CableMeasurements& measurements);

  std::size_t count() const { return count_; }
  std::size_t lengthCount(std::size_t cable) const { return lengths_[cable].size(); }
  std::size_t tensionCount(std::size_t cable) const { return tensions_[cable].size(); }
  double meanLength(std::size_t cable) const;   // [m]
  double meanTension(std::size_t cable) const;  // [N]

  // INVALID_INPUT with a sentence where a cable has too few samples, or where its samples spread, or their averages
  // drift, by more than their deviations [m, N] explain. Tensions only if they are to be used.
  Status checkRest(const RobotDescription& robot, bool use_tensions, double length_stddev, double tension_stddev) const;

 private:
  std::size_t count_ = 0;
  std::vector<std::vector<double>> lengths_, tensions_;  // of each cable
};

}  // namespace cdpr_kinetostatics

// Whether measurements disagree beyond their deviations, seen over the last messages.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimation/measured_robot.h"

namespace cdpr_kinetostatics {

// Sums of squares of each kind of observation: what is left of each message without its faults. What is left out of one
// message alone, and neither of the one before nor of the one after, is no fault of a sensor but a deviation larger
// than said, if it happens more than once. That it was a suspect there does not count: where all deviations are larger
// than said, most sensors are suspects.
class VarianceWindow {
 public:
  void add(const Candidate& candidate);
  void clear() { messages_.clear(); }

  // 1, or more where chance does not explain the disagreement. current: the candidate added last.
  DeviationFactors factors(const Candidate& current) const;

 private:
  struct Message {
    Eigen::Vector3d squares = Eigen::Vector3d::Zero(), redundancy = Eigen::Vector3d::Zero();  // by kind
    std::vector<LeftOut> left_out;
  };

  Message sum() const;

  std::vector<Message> messages_;
};

bool isWider(const DeviationFactors& factors);

// With the deviations widened.
EstimatorOptions widened(const EstimatorOptions& options, const DeviationFactors& factors);

}  // namespace cdpr_kinetostatics

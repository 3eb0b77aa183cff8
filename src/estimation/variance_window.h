// Whether measurements disagree beyond their deviations, seen over the last messages.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimation/measured_robot.h"

namespace cdpr_kinetostatics {

// Sums of squares of each kind of observation: what is left of each message without its faults. What is left out of one
// message alone, and at fault neither in the one before nor in the one after, by their answers or by their rivals, is
// no fault of a sensor but a deviation larger than said, if it happens more than once.
class VarianceWindow {
 public:
  // rivals: whose faults may be there instead.
  void add(const Candidate& candidate, const std::vector<Candidate>& rivals);
  void clear() { messages_.clear(); }

  // 1, or more where chance does not explain the disagreement. current: the candidate added last.
  DeviationFactors factors(const Candidate& current) const;

 private:
  struct Message {
    Eigen::Vector3d squares = Eigen::Vector3d::Zero(), redundancy = Eigen::Vector3d::Zero();  // by kind
    std::vector<LeftOut> left_out;
    std::vector<Observation> blamed;  // left out, or by a rival
  };

  Message sum() const;

  std::vector<Message> messages_;
};

bool isWider(const DeviationFactors& factors);

// With the deviations widened.
EstimatorOptions widened(const EstimatorOptions& options, const DeviationFactors& factors);

}  // namespace cdpr_kinetostatics

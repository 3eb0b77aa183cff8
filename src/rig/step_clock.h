// Says when a step is due, by a clock that may jump.
//
// Not by ros::Rate: that adds and subtracts times of ROS, which throws near the end of its range (2^32 s), and where a
// simulated clock jumps by more than 2^31 s.
#pragma once

namespace cdpr_kinetostatics {

class StepClock {
 public:
  // Steps per second.
  explicit StepClock(double rate) : period_(1.0 / rate) {}

  // Whether a step is due at the time `now` [s]. If it is, the next one will be a period later. After a jump of the
  // clock, and after steps that took longer than two periods, the steps begin anew.
  bool isDue(double now) {
    const bool went_back = now < last_;
    last_ = now;
    if (is_first_ || went_back || now > next_ + period_) next_ = now;
    is_first_ = false;
    if (now < next_) return false;
    next_ += period_;
    return true;
  }

  double timeOfNext() const { return next_; }

 private:
  const double period_;  // [s]
  bool is_first_ = true;
  double last_ = 0.0, next_ = 0.0;  // [s]
};

}  // namespace cdpr_kinetostatics

// How exact a solve has to be and when it has to stop: what the public solvers hand to those that they consist of.
#pragma once

#include <chrono>

namespace cdpr_kinetostatics {

struct SolveLimits {
  using Clock = std::chrono::steady_clock;

  // Relative tolerance of the integration; closure is iterated until forces change by less than tolerance times the
  // tension.
  double tolerance = 1e-8;

  // A solve that is still running at this moment stops with TIMED_OUT.
  Clock::time_point deadline = Clock::time_point::max();

  static bool isPast(Clock::time_point moment) { return moment != Clock::time_point::max() && Clock::now() > moment; }
  bool haveEnded() const { return isPast(deadline); }
};

// The moment this long from now [s]. A timeout that the clock cannot hold, an infinite one for instance, never ends.
SolveLimits::Clock::time_point deadlineAfter(std::chrono::duration<double> timeout);

}  // namespace cdpr_kinetostatics

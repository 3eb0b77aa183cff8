#include "cdpr_kinetostatics/cable/solve_limits.h"

namespace cdpr_kinetostatics {
namespace {

// A clock that counts nanoseconds in 64 bits runs for 292 years; half of that leaves room for the time since boot.
constexpr std::chrono::duration<double> kLongestTimeout = std::chrono::hours(24 * 365 * 146);

}  // namespace

SolveLimits::Clock::time_point deadlineAfter(std::chrono::duration<double> timeout) {
  if (!(timeout < kLongestTimeout)) return SolveLimits::Clock::time_point::max();
  return SolveLimits::Clock::now() + std::chrono::duration_cast<SolveLimits::Clock::duration>(timeout);
}

}  // namespace cdpr_kinetostatics

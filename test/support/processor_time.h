// The processor time of a thread: what other programs do meanwhile does not count.
#pragma once

#include <ctime>

namespace cdpr_kinetostatics {

// Of this thread [s].
inline double processorTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace cdpr_kinetostatics

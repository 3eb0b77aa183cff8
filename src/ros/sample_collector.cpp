#include "ros/sample_collector.h"

#include <algorithm>

namespace cdpr_kinetostatics {
namespace {

// How soon a wait notices that the node ends.
constexpr std::chrono::duration<double> kLook{0.1};

}  // namespace

void SampleCollector::add(const CableMeasurements& measurements) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (samples_.count() >= wanted_) return;
  samples_.add(measurements);
  if (samples_.count() == wanted_) changed_.notify_all();
}

RestingSamples SampleCollector::collect(std::size_t most, std::chrono::duration<double> window,
                                        const std::function<bool()>& go_on) {
  using Clock = std::chrono::steady_clock;
  std::unique_lock<std::mutex> lock(mutex_);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(window);
  samples_ = RestingSamples(cables_);
  wanted_ = most;
  while (samples_.count() < wanted_ && Clock::now() < end && go_on()) {
    const auto look = Clock::now() + std::chrono::duration_cast<Clock::duration>(kLook);
    changed_.wait_until(lock, std::min(end, look));
  }
  wanted_ = 0;
  return std::move(samples_);
}

}  // namespace cdpr_kinetostatics

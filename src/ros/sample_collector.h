// Copies of the measurements that arrive, for a service that waits for some.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

#include "estimation/resting_samples.h"

namespace cdpr_kinetostatics {

class SampleCollector {
 public:
  explicit SampleCollector(std::size_t cables) : samples_(cables), cables_(cables) {}

  // Takes microseconds, and none while nobody collects.
  void add(const CableMeasurements& measurements);

  // Waits for the next samples, at most so many, until the time is up or it should not go on. One caller at a time.
  RestingSamples collect(std::size_t most, std::chrono::duration<double> window, const std::function<bool()>& go_on);

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  RestingSamples samples_;
  const std::size_t cables_;
  std::size_t wanted_ = 0;  // 0: nobody collects
};

}  // namespace cdpr_kinetostatics

// Measurements on their way from the subscriber to the estimator: when it is full, the oldest make room, and are
// counted.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>

#include "ros/measurement_input.h"

namespace cdpr_kinetostatics {

class MeasurementQueue {
 public:
  explicit MeasurementQueue(std::size_t capacity) : capacity_(capacity) {}

  void push(Measurement measurement);
  // Waits until there is a measurement and returns the oldest; nothing once the queue is closed.
  std::optional<Measurement> pop();
  void clear();
  void close();
  // How many measurements have made room for newer ones.
  std::uint64_t superseded() const;

 private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Measurement> waiting_;
  std::uint64_t superseded_ = 0;
  bool closed_ = false;
};

}  // namespace cdpr_kinetostatics

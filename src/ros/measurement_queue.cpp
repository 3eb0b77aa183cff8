#include "ros/measurement_queue.h"

namespace cdpr_kinetostatics {

void MeasurementQueue::push(Measurement measurement) {
  const std::lock_guard<std::mutex> lock(mutex_);
  while (waiting_.size() >= capacity_) {
    Measurement& next = waiting_.size() > 1 ? waiting_[1] : measurement;
    next.reset_first |= waiting_.front().reset_first;
    waiting_.pop_front();
    ++superseded_;
  }
  waiting_.push_back(std::move(measurement));
  changed_.notify_one();
}

std::optional<Measurement> MeasurementQueue::pop() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [&] { return closed_ || !waiting_.empty(); });
  if (closed_) return std::nullopt;
  Measurement oldest = std::move(waiting_.front());
  waiting_.pop_front();
  return oldest;
}

void MeasurementQueue::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_.clear();
}

void MeasurementQueue::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

std::uint64_t MeasurementQueue::superseded() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return superseded_;
}

}  // namespace cdpr_kinetostatics

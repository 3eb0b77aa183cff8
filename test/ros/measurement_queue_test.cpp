#include "ros/measurement_queue.h"

#include <gtest/gtest.h>

#include <thread>

namespace cdpr_kinetostatics {
namespace {

Measurement numbered(std::uint32_t number, bool reset_first = false) {
  Measurement measurement;
  measurement.header.seq = number;
  measurement.reset_first = reset_first;
  return measurement;
}

TEST(MeasurementQueue, GivesTheOldestFirst) {
  MeasurementQueue queue(3);
  for (const std::uint32_t number : {1u, 2u, 3u}) queue.push(numbered(number));
  for (const std::uint32_t number : {1u, 2u, 3u}) EXPECT_EQ(queue.pop()->header.seq, number);
  EXPECT_EQ(queue.superseded(), 0u);
}

TEST(MeasurementQueue, TheOldestGiveWayAndAreCounted) {
  MeasurementQueue queue(2);
  for (const std::uint32_t number : {1u, 2u, 3u, 4u, 5u}) queue.push(numbered(number));
  EXPECT_EQ(queue.superseded(), 3u);
  EXPECT_EQ(queue.pop()->header.seq, 4u);
  EXPECT_EQ(queue.pop()->header.seq, 5u);
}

TEST(MeasurementQueue, AResetOutlivesTheMeasurementThatAskedForIt) {
  for (const std::size_t capacity : {1u, 2u}) {
    MeasurementQueue queue(capacity);
    queue.push(numbered(1, true));
    for (const std::uint32_t number : {2u, 3u, 4u}) queue.push(numbered(number));
    const auto next = queue.pop();
    EXPECT_EQ(next->header.seq, capacity == 1 ? 4u : 3u);
    EXPECT_TRUE(next->reset_first);
    if (capacity == 2) {
      EXPECT_FALSE(queue.pop()->reset_first);
    }
  }
}

TEST(MeasurementQueue, ClearedIsEmpty) {
  MeasurementQueue queue(3);
  queue.push(numbered(1));
  queue.clear();
  queue.push(numbered(2));
  EXPECT_EQ(queue.pop()->header.seq, 2u);
}

TEST(MeasurementQueue, ClosedLetsWhoWaitsGo) {
  MeasurementQueue queue(3);
  bool empty = false;
  std::thread waiting([&] { empty = !queue.pop(); });
  queue.close();
  waiting.join();
  EXPECT_TRUE(empty);
}

}  // namespace
}  // namespace cdpr_kinetostatics

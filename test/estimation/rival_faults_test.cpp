#include "estimation/rival_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "estimation/fault_search.h"
#include "measured_truth.h"

namespace cdpr_kinetostatics {
namespace {

// What leaving out each measurement alone brings, tried one by one, is what the search among rivals must find.
class RivalFaults : public ::testing::TestWithParam<const char*> {};

constexpr double kAsLikely = 16.0;  // a rival's sum of squares over the least

struct Tried {
  Selection selection;
  double squares;
};

std::vector<Tried> tryEach(const MeasuredRobot& measured, const RobotForces& start) {
  std::vector<Tried> tried;
  std::vector<Observation> all;
  for (std::size_t i = 0; i < measured.robot.cables.size(); ++i) {
    all.push_back({Observation::Kind::kLength, i});
    all.push_back({Observation::Kind::kTension, i});
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(measured.robot.freedoms()); ++k) {
    all.push_back({Observation::Kind::kLoad, k});
  }
  for (const Observation& one : all) {
    Selection without = measured.available;
    use(one, false, &without);
    const Candidate candidate = adjust(measured, start, without);
    if (candidate.adjusted.status.ok() && candidate.adjusted.stable) {
      tried.push_back({without, candidate.adjusted.weighted_squares});
    }
  }
  return tried;
}

// Offsets of 20 and of 100 deviations, of one length after the other.
TEST_P(RivalFaults, AreAllThatExplainTheMeasurementsAsWell) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, GetParam());
  int ambiguous = 0;
  for (std::size_t k = 0; k < 2 * simulated.robot.cables.size(); ++k) {
    const std::size_t cable = k / 2;
    CableMeasurements measurements = simulated.measure(simulated.truth, 1.0);
    *measurements.lengths[cable] += (k % 2 == 0 ? 20.0 : 100.0) * simulated.estimator.length_stddev;
    const MeasuredRobot measured = measuredBy(simulated, measurements);
    const RobotForces start = truthOf(simulated);
    Candidate best = leaveOutFaults(measured, start, measured.available);
    ASSERT_TRUE(best.adjusted.status.ok()) << best.adjusted.status.message;
    if (isSame(best.selection, measured.available)) continue;  // too little to be called a fault
    const std::vector<Candidate> rivals = rivalsOf(measured, &best);
    ASSERT_EQ(best.left_out.size(), 1u);
    EXPECT_GT(best.left_out[0].gain, 36.0);

    const std::vector<Tried> tried = tryEach(measured, start);
    const double least = std::min_element(tried.begin(), tried.end(), [](const Tried& a, const Tried& b) {
                           return a.squares < b.squares;
                         })->squares;
    // An answer without the known load goes before others that are as likely; 0.1: closer ones are equally good.
    const bool payload = (best.selection.load != measured.available.load).any();
    EXPECT_LT(best.adjusted.weighted_squares, least + (payload ? kAsLikely : 0.1)) << cable;
    for (const Tried& one : tried) {
      if (std::abs(one.squares - least - kAsLikely) < 0.2 || isSame(one.selection, best.selection)) continue;
      const bool found = std::any_of(rivals.begin(), rivals.end(),
                                     [&](const Candidate& rival) { return isSame(rival.selection, one.selection); });
      EXPECT_EQ(found, one.squares < least + kAsLikely) << "cable " << cable << ", squares " << one.squares - least;
      ambiguous += static_cast<int>(found);
    }
  }
  EXPECT_GT(ambiguous, 0) << "no fault had a rival: the test has seen nothing";
}

INSTANTIATE_TEST_SUITE_P(Redundant, RivalFaults, ::testing::Values("cogiro", "caroca", "scampi"),
                         [](const auto& robot) { return robot.param; });

TEST(RivalFaultsOfCoGiRo, AreNoneWhereNothingIsLeftOut) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements measurements = simulated.measure(simulated.truth, 1.0);
  const MeasuredRobot measured = measuredBy(simulated, measurements);
  Candidate best = leaveOutFaults(measured, truthOf(simulated), measured.available);
  EXPECT_TRUE(rivalsOf(measured, &best).empty());
  EXPECT_TRUE(best.left_out.empty());
}

TEST(RivalFaultsOfCoGiRo, AreNotSoughtWhenTimeIsOver) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  CableMeasurements measurements = simulated.measure(simulated.truth, 1.0);
  *measurements.lengths[2] += 0.05;
  const MeasuredRobot measured = measuredBy(simulated, measurements);
  Candidate best = leaveOutFaults(measured, truthOf(simulated), measured.available);
  ASSERT_FALSE(isSame(best.selection, measured.available));
  ASSERT_FALSE(rivalsOf(measured, &best).empty());
  const MeasuredRobot late{measured.robot,     measured.options, measurements, std::chrono::steady_clock::now(),
                           measured.available, measured.rungs};
  EXPECT_TRUE(rivalsOf(late, &best).empty());
  EXPECT_TRUE(unprovenFaults(late, best).empty());
}

// An offset that shows with four of its residual's deviations is no fault yet, but an answer without it is among those
// that the covariance covers.
TEST(RivalFaultsOfCoGiRo, AResidualBelowTheThresholdIsUnproven) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  CableMeasurements measurements = simulated.measure(simulated.truth, 0.0);
  const MeasuredRobot clean = measuredBy(simulated, measurements);
  const Candidate good = leaveOutFaults(clean, truthOf(simulated), clean.available);
  EXPECT_TRUE(unprovenFaults(clean, good).empty());
  const auto of_length =
      std::find_if(good.adjusted.observations.begin(), good.adjusted.observations.end(),
                   [](const Observation& o) { return o.kind == Observation::Kind::kLength && o.index == 2; });
  *measurements.lengths[2] += 4.0 / std::sqrt(of_length->redundancy) * simulated.estimator.length_stddev;
  const MeasuredRobot measured = measuredBy(simulated, measurements);
  const Candidate best = leaveOutFaults(measured, truthOf(simulated), measured.available);
  ASSERT_TRUE(isSame(best.selection, measured.available));
  const std::vector<Candidate> unproven = unprovenFaults(measured, best);
  EXPECT_TRUE(std::any_of(unproven.begin(), unproven.end(),
                          [](const Candidate& candidate) { return !candidate.selection.lengths[2]; }));
}

}  // namespace
}  // namespace cdpr_kinetostatics

// By how much measurements disagree beyond their deviations, from drawn noise.
#include "estimation/variance_window.h"

#include <gtest/gtest.h>

#include "estimation/fault_search.h"
#include "measured_truth.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kWindow = 10;  // messages

class VarianceFactors : public ::testing::Test {
 protected:
  SimulatedRobot simulated_ = simulatedRobot(ROBOT_DIR, "cogiro");

  CableMeasurements drawn(double lengths, double tensions) {
    CableMeasurements measurements = simulated_.measure(simulated_.truth, 0.0);
    for (auto& length : measurements.lengths) {
      *length += lengths * simulated_.estimator.length_stddev * simulated_.dice.normal();
    }
    for (auto& tension : measurements.tensions) {
      *tension += tensions * simulated_.estimator.tension_stddev * simulated_.dice.normal();
    }
    return measurements;
  }

  Candidate adjusted(const CableMeasurements& measurements) {
    const MeasuredRobot measured = measuredBy(simulated_, measurements);
    return adjust(measured, truthOf(simulated_), measured.available);
  }

  DeviationFactors after(int messages, double lengths, double tensions, VarianceWindow* window) {
    DeviationFactors factors;
    for (int k = 0; k < messages; ++k) {
      const Candidate candidate = adjusted(drawn(lengths, tensions));
      window->add(candidate);
      factors = window->factors(candidate);
    }
    return factors;
  }
};

TEST_F(VarianceFactors, AreOneForNoise) {
  int wider = 0;
  VarianceWindow window;
  constexpr int kMessages = 300;
  for (int k = 0; k < kMessages; ++k) wider += static_cast<int>(isWider(after(1, 1.0, 1.0, &window)));
  EXPECT_LE(wider, kMessages / 20);  // one in 700 for each kind; ten messages share what is rare
}

TEST_F(VarianceFactors, TellTheKindThatDisagreesAndByHowMuch) {
  for (const double times : {3.0, 5.0, 20.0}) {
    double lengths = 0.0, tensions = 0.0;
    constexpr int kWindows = 20;
    for (int k = 0; k < kWindows; ++k) {
      VarianceWindow window;
      const DeviationFactors of_lengths = after(kWindow, times, 1.0, &window);
      lengths += of_lengths.lengths / kWindows;
      EXPECT_LT(of_lengths.tensions, 0.4 * times);
      window.clear();
      const DeviationFactors of_tensions = after(kWindow, 1.0, times, &window);
      tensions += of_tensions.tensions / kWindows;
      EXPECT_LT(of_tensions.lengths, 0.8 * times);  // two redundant lengths a message say little
    }
    // One window has some 20 redundant lengths, which fixes a deviation to 16 %; the mean of 20 windows to 4 %.
    EXPECT_NEAR(lengths, times, 0.15 * times);
    EXPECT_NEAR(tensions, times, 0.15 * times);
  }
}

TEST_F(VarianceFactors, ForgetWithTenGoodMessages) {
  VarianceWindow window;
  EXPECT_GT(after(kWindow, 20.0, 20.0, &window).lengths, 5.0);
  EXPECT_GT(after(kWindow - 1, 0.0, 0.0, &window).lengths, 1.0);
  EXPECT_FALSE(isWider(after(1, 0.0, 0.0, &window)));
}

// A sensor that is left out of one message after the other is faulty; left out now and then it is worse than said.
TEST_F(VarianceFactors, CountWhatIsLeftOutNowAndThen) {
  const LeftOut gross{{Observation::Kind::kLength, 3}, 400.0, 1.0};
  const Candidate good = adjusted(drawn(0.0, 0.0));
  Candidate faulty = good;
  faulty.left_out = {gross};
  VarianceWindow always, sometimes, once;
  for (int k = 0; k < kWindow; ++k) {
    always.add(faulty);
    sometimes.add(k % 3 == 1 ? faulty : good);
    once.add(k == 4 ? faulty : good);
  }
  EXPECT_FALSE(isWider(always.factors(faulty)));
  EXPECT_FALSE(isWider(once.factors(good)));
  EXPECT_GT(sometimes.factors(good).lengths, 3.0);
  EXPECT_EQ(sometimes.factors(good).tensions, 1.0);
}

TEST_F(VarianceFactors, WidenTheDeviationsOfTheirKind) {
  const EstimatorOptions wide = widened(simulated_.estimator, {2.0, 3.0, 4.0});
  EXPECT_EQ(wide.length_stddev, 2.0 * simulated_.estimator.length_stddev);
  EXPECT_EQ(wide.tension_stddev, 3.0 * simulated_.estimator.tension_stddev);
  EXPECT_TRUE(wide.load_stddev.isApprox(4.0 * simulated_.estimator.load_stddev));
}

}  // namespace
}  // namespace cdpr_kinetostatics

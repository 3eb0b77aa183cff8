// A deadline is kept even where the problem is at its worst: loops so narrow that the catenary turns around
// within a hair's breadth.
#include <gtest/gtest.h>

#include <chrono>
#include <ostream>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "processor_time.h"
#include "random_cables.h"

namespace cdpr_kinetostatics {
namespace {

const CableCase kNarrowLoops[] = {
    {{9281.0957802552675, 6.0151997170098671e-09, 44.593361382507943},
     0.01556342652132252,
     1.3535220281694627e-05,
     0.015559180164245718,
     2.1},
    {{54512567.217637584, 785.33401189148753, 1.8836122153757247},
     75.147260897174007,
     0.17814205170157882,
     -75.133638675471886,
     31.9},
    {{16980.837737627069, 4824.1264885485834, 2.2056518955406106},
     131.62993919041438,
     0.14704025388867595,
     131.60460556064638,
     2.1},
    {{101656048.40618175, 0.017547441687114376, 13.555312005537491},
     102.90301616217944,
     0.11566553086324316,
     102.88928008994634,
     311.2},
};

// A search that has lost its deadline goes on for seconds. How late the answers are, in milliseconds, is for the fuzzed
// programs to measure: no test depends on the speed of the machine [s].
constexpr double kEndless = 1.0;

class NarrowLoop : public ::testing::TestWithParam<CableCase> {};

TEST_P(NarrowLoop, IsAnsweredOrGivenUpInTime) {
  const CableCase& c = GetParam();
  CableSolverOptions options;
  const double start = processorTime();
  options.timeout = std::chrono::milliseconds(100);
  const CableSolution s = findForces(c.cable, c.length, c.x, c.y, options);
  EXPECT_LT(processorTime() - start, kEndless) << s.status.message;
  EXPECT_TRUE(s.status.ok() || !s.status.message.empty());
}

INSTANTIATE_TEST_SUITE_P(Worst, NarrowLoop, ::testing::ValuesIn(kNarrowLoops));

// A rope of SCAMPI's that would have to be stretched to five times its length: every part of the search comes to its
// limits.
TEST(Deadline, EndsTheSearchForALength) {
  CableSolverOptions options;
  options.model = Model::kAuto;
  options.tolerance = 7.58e-12;
  options.timeout = std::chrono::duration<double>(8.3e-3);
  const double start = processorTime();
  const CableSolution s = findLength({153310.0, 0.07, 0.1034955}, 121.374, -232.325, 0.041675, 53.12, options);
  EXPECT_LT(processorTime() - start, kEndless);
  EXPECT_TRUE(s.status.code == Code::kTimedOut || s.status.ok()) << s.status.message;
}

// Openings of a narrow loop take many catenaries, none of which is a start.
TEST(Deadline, EndsTheSearchForACatenaryToStartFrom) {
  CableSolverOptions options;
  options.timeout = std::chrono::duration<double>(1e-3);
  const double start = processorTime();
  const CableSolution s =
      findForces({441928652576.9, 1.29e-6, 10.0}, 95.99501459912247, 0.0, -95.99501459912247, options);
  EXPECT_LT(processorTime() - start, kEndless);
  EXPECT_EQ(s.status.code, Code::kTimedOut) << s.status.message;
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Problem 3 has several answers, or none: lengths either side of a fold, four of a stiff bar, and the least
// tension that can hold a cable (docs/theory.md section 1).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <ostream>
#include <string>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

CableSolverOptions options(Model model, double tolerance = 1e-10) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = tolerance;
  return result;
}

struct Fold {
  Model model;
  double tension, ratio;   // least T_A [N] and where, L/chord
  double shorter, longer;  // L/chord at 5.13 N
};

void PrintTo(const Fold& fold, std::ostream* out) { *out << modelName(fold.model); }

class FoldOfTheRope : public ::testing::TestWithParam<Fold> {
 protected:
  const double chord_ = std::hypot(7.0, 4.0);
  CableSolution lengthAt(double tension, double hint) const {
    return findLength(steelRope(), 7.0, -4.0, tension, hint, options(GetParam().model));
  }
};

TEST_P(FoldOfTheRope, HasOneLengthOnEitherSide) {
  const CableSolution taut = lengthAt(5.13, 0.0);
  ASSERT_TRUE(taut.status.ok()) << taut.status.message;
  EXPECT_NEAR(taut.length / chord_, GetParam().shorter, 6e-5);
  const CableSolution sagging = lengthAt(5.13, 1.6 * chord_);
  ASSERT_TRUE(sagging.status.ok()) << sagging.status.message;
  EXPECT_NEAR(sagging.length / chord_, GetParam().longer, 6e-5);
  for (const CableSolution* solution : {&taut, &sagging}) EXPECT_NEAR(solution->tension_a, 5.13, 1e-9);
}

TEST_P(FoldOfTheRope, TheHintChoosesTheNearest) {
  const double middle = 0.5 * (GetParam().shorter + GetParam().longer);
  for (const double hint : {0.5, 1.0, GetParam().shorter, middle - 1e-3}) {
    EXPECT_NEAR(lengthAt(5.13, hint * chord_).length / chord_, GetParam().shorter, 6e-5) << hint;
  }
  for (const double hint : {middle + 1e-3, GetParam().longer, 1.6, 3.0}) {
    EXPECT_NEAR(lengthAt(5.13, hint * chord_).length / chord_, GetParam().longer, 6e-5) << hint;
  }
}

TEST_P(FoldOfTheRope, JustAboveTheLeastTensionBothLengthsAreClose) {
  const CableSolution s = lengthAt(GetParam().tension + 1e-3, 0.0);
  ASSERT_TRUE(s.status.ok()) << s.status.message;
  EXPECT_NEAR(s.length / chord_, GetParam().ratio, 0.01);
}

TEST_P(FoldOfTheRope, BelowTheLeastTensionItSaysWhatThatIs) {
  for (const double tension : {0.1, 1.0, 4.0, GetParam().tension - 1e-3}) {
    for (const double hint : {0.0, 1.2 * chord_}) {
      const CableSolution s = lengthAt(tension, hint);
      EXPECT_EQ(s.status.code, Code::kInfeasible) << tension << ", hint " << hint;
      const std::size_t at = s.status.message.rfind("= ");
      ASSERT_NE(at, std::string::npos) << s.status.message;
      EXPECT_NEAR(std::atof(s.status.message.c_str() + at + 2), GetParam().tension, 6e-4) << s.status.message;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, FoldOfTheRope,
                         ::testing::Values(Fold{Model::kCatenary, 4.890, 1.2245, 1.1136, 1.4284},
                                           Fold{Model::kBending, 4.849, 1.2185, 1.1048, 1.4405}));

// Lengths of the paper's bar between (0, 0) and (5, -2.5) with 220 N at A, over the chord; computed by
// collocation, following the sagging equilibrium as the bar gets longer.
constexpr double kBarRatios[] = {1.001753, 1.023234, 1.286801, 2.639150};

TEST(LengthBranches, ABarHasFourLengthsForOneTension) {
  const double chord = std::hypot(5.0, 2.5);
  for (const double ratio : kBarRatios) {
    const CableSolution s =
        findLength(paperBar(), 5.0, -2.5, 220.0, (1.0 + 1.003 * (ratio - 1.0)) * chord, options(Model::kBending));
    ASSERT_TRUE(s.status.ok()) << ratio << ": " << s.status.message;
    EXPECT_NEAR(s.length / chord, ratio, 2e-6);
    EXPECT_NEAR(s.tension_a, 220.0, 1e-8);
  }
}

TEST(LengthBranches, EveryHintFindsTheNearestOfTheBarsLengths) {
  const double chord = std::hypot(5.0, 2.5);
  for (double hint = 0.9; hint < 3.4; hint += 0.0437) {
    double nearest = kBarRatios[0];
    for (const double ratio : kBarRatios) {
      if (std::abs(ratio - hint) < std::abs(nearest - hint)) nearest = ratio;
    }
    const CableSolution s = findLength(paperBar(), 5.0, -2.5, 220.0, hint * chord, options(Model::kBending));
    ASSERT_TRUE(s.status.ok()) << hint << ": " << s.status.message;
    EXPECT_NEAR(s.length / chord, nearest, 2e-6) << "hint " << hint;
  }
}

// The catenary of this tension is 1.6 % longer than the chord, beyond the bar's fold and its largest compression.
TEST(LengthBranches, TheTautSideIsNotMistakenForTheCompressedOne) {
  const CableProperties bar{816865264.87219501, 853126.1266076063, 2.040586986233341};
  for (const double hint : {0.0, 61.366342457010425}) {
    const CableSolution s =
        findLength(bar, 61.242675015853834, 3.7875992055756633, 199.339513, hint, options(Model::kBending));
    ASSERT_TRUE(s.status.ok()) << "hint " << hint << ": " << s.status.message;
    EXPECT_NEAR(s.length, 61.366342457010425, 1e-7) << "hint " << hint;
  }
}

struct DeepLoop {
  CableProperties cable;
  double x, y, tension;
};

// Lengths at which following the curve and a cold start may end in different equilibria.
TEST(LengthBranches, ConvergedMeansTheTensionAskedFor) {
  const DeepLoop loops[] = {{{21425533.187671162, 25.708093075238839, 10.743368546209702},
                             1.5073222190367652,
                             -1.2487734516903555,
                             40.4827641},
                            {{42459.230252303991, 0.0158831678779877, 0.30679606431766038},
                             0.44911293541724684,
                             -0.84280769671082323,
                             0.448097046},
                            {{326769965.60911942, 3475835.3825006029, 0.50239788583909728},
                             195.47475479956555,
                             3.0631047769585726,
                             277.500537}};
  for (const DeepLoop& loop : loops) {
    const CableSolution s = findLength(loop.cable, loop.x, loop.y, loop.tension, 0.0, options(Model::kBending, 1e-8));
    if (s.status.ok()) {
      EXPECT_NEAR(s.tension_a, loop.tension, 1e-7 * loop.tension);
    } else {
      ADD_FAILURE() << loop.tension << " N: " << s.status.message;
    }
  }
}

TEST(LengthBranches, WithoutAHintTheBarsShortestLength) {
  const double chord = std::hypot(5.0, 2.5);
  const CableSolution s = findLength(paperBar(), 5.0, -2.5, 220.0, 0.0, options(Model::kBending));
  ASSERT_TRUE(s.status.ok()) << s.status.message;
  EXPECT_NEAR(s.length / chord, kBarRatios[0], 2e-6);
}

TEST(LengthBranches, TheBarsExtremeTensions) {
  const double chord = std::hypot(5.0, 2.5);
  const auto shortest = [&](double tension) {
    const CableSolution s = findLength(paperBar(), 5.0, -2.5, tension, 0.0, options(Model::kBending, 1e-9));
    EXPECT_TRUE(s.status.ok()) << tension << ": " << s.status.message;
    return s.length / chord;
  };
  EXPECT_NEAR(shortest(64.2), 1.0041, 3e-4);
  const CableSolution below = findLength(paperBar(), 5.0, -2.5, 63.5, 0.0, options(Model::kBending, 1e-9));
  EXPECT_EQ(below.status.code, Code::kInfeasible);
  EXPECT_NE(below.status.message.find("63.9"), std::string::npos) << below.status.message;
}

TEST(LengthBranches, AHintOfTheBranchAboveItsMinimumFallsBackToTheNearestThatExists) {
  // 100 N is below the second minimum, 171 N: only the two lengths near 1.004 are left.
  const double chord = std::hypot(5.0, 2.5);
  const CableSolution s = findLength(paperBar(), 5.0, -2.5, 100.0, 2.6 * chord, options(Model::kBending));
  ASSERT_TRUE(s.status.ok()) << s.status.message;
  EXPECT_NEAR(s.tension_a, 100.0, 1e-8);
  EXPECT_GT(s.length / chord, 1.0042);
  EXPECT_LT(s.length / chord, 1.0234);
}

// A thin beam bent into a loop: a shape followed from the taut side would be another, and so its tension.
TEST(LengthOfABeam, TheHintIsTakenByItsOwnShape) {
  const CableProperties beam{77.825, 32043.6, 0.00160145};
  const double length = 203.215;
  const CableSolution bent = findForces(beam, length, 30.4423, 49.9919, options(Model::kBending));
  ASSERT_TRUE(bent.status.ok()) << bent.status.message;
  const CableSolution found =
      findLength(beam, 30.4423, 49.9919, bent.tension_a, 1.000001 * length, options(Model::kBending));
  ASSERT_TRUE(found.status.ok()) << found.status.message;
  EXPECT_NEAR(found.length, length, 1e-8 * length);
  EXPECT_NEAR(found.horizontal_force, bent.horizontal_force, 1e-7 * bent.tension_a);
}

}  // namespace
}  // namespace cdpr_kinetostatics

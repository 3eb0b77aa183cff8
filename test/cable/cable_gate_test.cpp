// What the gate lets through, and what it stops.
#include "cable/cable_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cable/catenary.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-8;

// A solved rope, for a test to spoil its description.
struct Solved {
  explicit Solved(Model model) : cable(steelRope(), model, kTolerance) {
    EXPECT_TRUE(cable.startBetween(8.5, 7.0, -4.0, SolveLimits{kTolerance}).ok()) << modelName(model);
    solution = cable.describe(7.0, -4.0, 5);
  }
  Code code() const { return verdictOf(cable, solution, kTolerance).code; }

  SaggingCable cable;
  CableSolution solution;
};

constexpr Model kModels[] = {Model::kStraightElastic,   Model::kCatenaryInextensible, Model::kCatenary,
                             Model::kCatenaryCorrected, Model::kBendingInextensible,  Model::kBending};

TEST(CableGate, LetsAnAnswerThrough) {
  for (const Model model : kModels) EXPECT_EQ(Solved(model).code(), Code::kConverged) << modelName(model);
}

TEST(CableGate, StopsWhatIsNoNumber) {
  double CableSolution::*const numbers[] = {&CableSolution::x, &CableSolution::sag, &CableSolution::tension_b,
                                            &CableSolution::max_shear, &CableSolution::closure_residual};
  for (const Model model : kModels) {
    for (double CableSolution::*const number : numbers) {
      Solved solved(model);
      solved.solution.*number = std::numeric_limits<double>::quiet_NaN();
      EXPECT_EQ(solved.code(), Code::kNotConverged) << modelName(model);
    }
    Solved solved(model);
    solved.solution.profile[2].moment = std::numeric_limits<double>::infinity();
    EXPECT_EQ(solved.code(), Code::kNotConverged) << modelName(model);
  }
}

TEST(CableGate, StopsAnEndElsewhere) {
  Solved solved(Model::kCatenary);
  const double accepted = acceptedClosure(solved.solution, kTolerance);
  EXPECT_NEAR(accepted, kTolerance * 8.5, 0.01 * kTolerance * 8.5);  // rounding counts for little in a hanging rope
  solved.solution.closure_residual = 0.9 * accepted;
  EXPECT_EQ(solved.code(), Code::kConverged);
  solved.solution.closure_residual = 1.1 * accepted;
  EXPECT_EQ(solved.code(), Code::kNotConverged);
}

TEST(CableGate, StopsMomentsThatDoNotJoin) {
  Solved solved(Model::kBending);
  solved.solution.moment_residual = 1e-3 * solved.solution.tension_a * solved.solution.length;
  EXPECT_EQ(solved.code(), Code::kNotConverged);
}

// The paper's bar of 5.592 m between (0, 0) and (5, -2.5): an arch in compression solves the equations as well.
TEST(CableGate, StopsTheArch) {
  SaggingCable arch(paperBar(), Model::kBending, kTolerance);
  const SolveOutcome outcome = arch.startUnder(5.592, {-1701.42, -781.82}, SolveLimits{kTolerance});
  if (outcome.ok()) {
    const CableSolution solution = arch.describe(5.0, -2.5, 0);
    EXPECT_TRUE(arch.onBranch() || verdictOf(arch, solution, kTolerance).code == Code::kWrongBranch);
  }
}

// Rounding of its forces moves the end of a line without load across by all its length: that is no error.
TEST(CableGate, KnowsWhatRoundingDoesToTheEnd) {
  CableSolution solution;
  solution.length = 10.0;
  solution.tension_a = solution.tension_b = 1e3;
  solution.end_jacobian(0, 0) = 1e4;  // [m/N]
  EXPECT_NEAR(acceptedClosure(solution, 1e-13), 1e-13 * 10.0 + 1e-13 * 1e4 * 1e3, 1e-12);
}

// Near H = 0 the first-order effect of bending on a slack catenary goes beyond all bounds: 1e14 m here.
TEST(CableGate, TheCorrectedCatenaryNextToTheVerticalIsRefused) {
  CableSolverOptions options;
  options.model = Model::kCatenaryCorrected;
  for (const double x : {1e-9, 1e-6, 1e-3, 0.1}) {
    const CableSolution s = findForces(steelRope(), 5.05, x, -5.0, options);
    EXPECT_EQ(s.status.code, Code::kNotConverged) << x;
    EXPECT_NE(s.status.message.find("bending model"), std::string::npos) << s.status.message;
  }
  EXPECT_EQ(findPosition(steelRope(), 5.0, 1e-6, 1.0, options).status.code, Code::kNotConverged);
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Newton's method on the whole robot: how fast it converges, what it says of a state, and where its prediction leads.
#include "robot/coupled_newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "cdpr_kinetostatics/robot/forward.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

class CoupledNewtonOfCogiro : public testing::TestWithParam<Model> {
 protected:
  CoupledNewtonOfCogiro()
      : at_(solveInverse(robot_, requestFor(robot_, robot_.home), patient(GetParam(), kTolerance))) {
    EXPECT_TRUE(at_.report.status.ok()) << at_.report.status.message;
  }

  // The solution's pose moved, and the cables under the solution's forces times a factor.
  CoupledState stateNear(const Pose& pose, double factor) const {
    CoupledState state;
    state.pose = pose;
    for (const CableResult& result : at_.cables) {
      SaggingCable cable(robot_.cables[state.cables.size()].properties, GetParam(), kTolerance);
      cable.start(result.cable.length,
                  {factor * result.cable.horizontal_force, factor * result.cable.vertical_force_a});
      state.cables.push_back(std::move(cable));
    }
    return state;
  }

  static constexpr double kTolerance = 1e-11;
  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  const RobotSolution at_;
  CoupledNewton newton_{robot_};
};

TEST_P(CoupledNewtonOfCogiro, ResidualsAreThoseOfTheLinearisedState) {
  Dice dice(41);
  CoupledState state = stateNear(dice.away(at_.pose, 0.01, 0.01), 1.1);
  std::vector<PlaneForces> forces;
  for (const SaggingCable& cable : state.cables) {
    forces.push_back({cable.horizontalForce(), cable.verticalForceA(), cable.length()});
  }
  const Wrench total = totalWrench(robot_, Wrench::Zero(), state.pose, forces);
  ASSERT_TRUE(newton_.linearise(Wrench::Zero(), Steps::kNew, &state));
  double open = 0.0;
  for (std::size_t i = 0; i < state.cables.size(); ++i) {
    const Eigen::Vector3d to_b = attachmentInWorld(state.pose, robot_.cables[i].attachment) - robot_.cables[i].anchor;
    const Eigen::Vector2d end(to_b.head<2>().norm(), to_b.z());
    open = std::max(open, (state.cables[i].end().position - end).norm());
  }
  const Residuals residuals = newton_.residuals();
  EXPECT_NEAR(residuals.closure, open, 1e-12);
  EXPECT_NEAR(residuals.force, total.head<3>().norm(), 1e-9 * robot_.weight());
  EXPECT_NEAR(residuals.moment, total.tail<3>().norm(), 1e-9 * robot_.weight());
}

TEST_P(CoupledNewtonOfCogiro, ConvergesToThePoseOfTheLengths) {
  Dice dice(42);
  for (int i = 0; i < 5; ++i) {
    CoupledState state = stateNear(dice.away(at_.pose, 0.02, 0.02), 1.05);
    const SearchOutcome outcome = solveCoupled(Wrench::Zero(), {kTolerance}, &newton_, &state);
    ASSERT_TRUE(outcome.ok()) << outcome.status.message;
    EXPECT_LE(outcome.iterations, 15);
    EXPECT_TRUE(samePose(state.pose, at_.pose, 1e-8));
    EXPECT_TRUE(isOnBranch(platformStability(robot_, newton_.stiffness()), state));
  }
}

TEST_P(CoupledNewtonOfCogiro, AFailureSaysHowFarItGot) {
  Dice dice(43);
  CoupledState state = stateNear(dice.away(at_.pose, 0.05, 0.05), 1.2);
  CoupledOptions options{kTolerance};
  options.max_iterations = 2;
  SearchOutcome outcome = solveCoupled(Wrench::Zero(), options, &newton_, &state);
  EXPECT_EQ(outcome.status.code, Code::kNotConverged);
  EXPECT_EQ(outcome.iterations, 2);
  EXPECT_GT(outcome.residuals.closure, 0.0);
  EXPECT_GT(outcome.residuals.force, 0.0);
  options.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  outcome = solveCoupled(Wrench::Zero(), options, &newton_, &state);
  EXPECT_EQ(outcome.status.code, Code::kTimedOut);
  EXPECT_EQ(outcome.iterations, 0);
}

// The error of a prediction is of second order in the change of lengths and load.
TEST_P(CoupledNewtonOfCogiro, PredictsToFirstOrder) {
  double last = 0.0;
  for (const double share : {1.0, 0.5}) {
    CoupledState state = stateNear(at_.pose, 1.0);
    ASSERT_TRUE(solveCoupled(Wrench::Zero(), {kTolerance}, &newton_, &state).ok());
    std::vector<double> lengths;
    Wrench load = Wrench::Zero();
    load.head<3>() = share * 0.02 * robot_.weight() * Eigen::Vector3d(1.0, -1.0, -2.0);
    for (std::size_t i = 0; i < state.cables.size(); ++i) {
      // Lengths of a pose 20 mm away, so that all cables stay taut.
      Pose there = at_.pose;
      there.position += share * Eigen::Vector3d(0.02, 0.01, -0.01);
      const double chord = (attachmentInWorld(there, robot_.cables[i].attachment) - robot_.cables[i].anchor).norm();
      const double here = (attachmentInWorld(at_.pose, robot_.cables[i].attachment) - robot_.cables[i].anchor).norm();
      lengths.push_back(state.cables[i].length() * chord / here);
    }
    const double size = newton_.predict(lengths, load, &state);
    EXPECT_LT(size, 0.5);
    ForwardRequest request;
    request.lengths = lengths;
    request.external_wrench = load;
    request.seed = at_.pose;
    const RobotSolution exact = solveForward(robot_, request, patient(GetParam(), kTolerance));
    ASSERT_TRUE(exact.report.status.ok()) << exact.report.status.message;
    const double moved = (exact.pose.position - at_.pose.position).norm();
    const double error = (state.pose.position - exact.pose.position).norm();
    EXPECT_LT(error, 0.05 * moved);
    EXPECT_TRUE(last == 0.0 || error < 0.4 * last) << error << " after " << last;
    last = error;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, CoupledNewtonOfCogiro,
                         testing::Values(Model::kCatenary, Model::kCatenaryCorrected, Model::kBending),
                         [](const auto& model) { return std::string(modelName(model.param)); });

}  // namespace
}  // namespace cdpr_kinetostatics

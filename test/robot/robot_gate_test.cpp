// The gate of a robot's answers: answers pass it, and none of them does once it is spoilt.
#include "robot/robot_gate.h"

#include <gtest/gtest.h>

#include <limits>

#include "robot/solution_assembly.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

class RobotGate : public testing::Test {
 protected:
  RobotGate() {
    const RobotSolution inverse = solveInverse(robot_, requestFor(robot_, robot_.home), patient(Model::kCatenary));
    answer_ = forward(robot_, lengthsOf(inverse), robot_.home, patient(Model::kCatenary, kTolerance));
  }

  Status verdict(const RobotSolution& solution, const Wrench& load = Wrench::Zero()) const {
    return verdictOf(robot_, solution, load, kTolerance);
  }

  // The residuals summed anew for cables that were changed, or another load.
  RobotSolution reassembled(RobotSolution solution, const Wrench& load) const {
    std::vector<CableSolution> cables;
    for (const CableResult& result : solution.cables) cables.push_back(result.cable);
    assemble(robot_, load, cables, &solution);
    return solution;
  }

  static constexpr double kTolerance = 1e-9;
  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  RobotSolution answer_;
};

TEST_F(RobotGate, AnAnswerPassesWithoutAWord) {
  ASSERT_TRUE(answer_.report.status.ok());
  EXPECT_TRUE(verdict(answer_).ok());
  EXPECT_TRUE(verdict(answer_).message.empty());
}

TEST_F(RobotGate, AnUnknownLoadIsFound) {
  Wrench load = Wrench::Zero();
  load.x() = 0.01;
  EXPECT_EQ(verdict(reassembled(answer_, load), load).code, Code::kNotConverged);
  load.x() = 0.0;
  load(4) = 0.01;
  const Status turned = verdict(reassembled(answer_, load), load);
  EXPECT_EQ(turned.code, Code::kNotConverged);
  EXPECT_NE(turned.message.find("balance"), std::string::npos) << turned.message;
}

TEST_F(RobotGate, AnOpenCableIsNamed) {
  RobotSolution open = answer_;
  open.cables[3].cable.closure_residual = 1e-4;
  const Status status = verdict(open);
  EXPECT_EQ(status.code, Code::kNotConverged);
  EXPECT_NE(status.message.find(robot_.cables[3].name), std::string::npos) << status.message;
}

TEST_F(RobotGate, NothingThatIsNotFinitePasses) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    RobotSolution nowhere = answer_;
    nowhere.pose.position.y() = bad;
    RobotSolution unclear = answer_;
    unclear.report.force_residual = bad;
    RobotSolution open = answer_;
    open.cables[0].cable.closure_residual = bad;
    for (const RobotSolution& solution : {nowhere, unclear, open}) {
      EXPECT_EQ(verdict(solution).code, Code::kNotConverged) << verdict(solution).message;
    }
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

// The linearised program of inverse kinetostatics against differences of the wrench, its cables solved anew.
#include "robot/tension_program.h"

#include <gtest/gtest.h>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "robot/platform_statics.h"
#include "robot_audit.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

class TensionProgram : public testing::Test {
 protected:
  TensionProgram() {
    external_ << 20.0, -10.0, 5.0, 1.0, 2.0, -3.0;
    pose_ = Dice(61).away(robot_.home, 0.5, 0.1);
    for (const CableDescription& description : robot_.cables) {
      tensions_.push_back(800.0 + 100.0 * static_cast<double>(tensions_.size()));
      InverseCable c;
      c.cable = SaggingCable(description.properties, Model::kCatenary, 1e-11);
      const CableSolution at = solvedAt(description, pose_, tensions_.back());
      c.cable.start(at.length, {at.horizontal_force, at.vertical_force_a});
      c.lower = description.tension_min;
      c.upper = description.tension_max;
      EXPECT_TRUE(c.linearise(description, pose_, Steps::kNew, kTautInSearch));
      cables_.push_back(std::move(c));
    }
    problem_.preferred = Eigen::VectorXd::LinSpaced(8, 500.0, 1200.0);
    problem_.external = external_;
  }

  static CableSolution solvedAt(const CableDescription& description, const Pose& pose, double tension) {
    CableSolverOptions options;
    options.model = Model::kCatenary;
    options.tolerance = 1e-12;
    const Eigen::Vector3d to_b = attachmentInWorld(pose, description.attachment) - description.anchor;
    const CableSolution at = findLength(description.properties, to_b.head<2>().norm(), to_b.z(), tension, 0.0, options);
    EXPECT_TRUE(at.status.ok()) << at.status.message;
    return at;
  }

  // With moments over the lever, every cable at its tension by problem 3.
  Wrench scaledWrench(const Pose& pose, const std::vector<double>& tensions) const {
    std::vector<PlaneForces> forces;
    for (std::size_t i = 0; i < tensions.size(); ++i) {
      const CableSolution at = solvedAt(robot_.cables[i], pose, tensions[i]);
      forces.push_back({at.horizontal_force, at.vertical_force_a, at.length});
    }
    Wrench wrench = totalWrench(robot_, external_, pose, forces);
    wrench.tail<3>() /= robot_.lever();
    return wrench;
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  Wrench external_;
  Pose pose_;
  std::vector<double> tensions_;
  std::vector<InverseCable> cables_;
  InverseProblem problem_{robot_, Wrench::Zero(), {}, {}};
};

TEST_F(TensionProgram, BalancesWhatTheCablesLeaveUnbalanced) {
  const TensionProblem program = tensionProgram(problem_, pose_, cables_, {});
  ASSERT_EQ(program.matrix.rows(), 6);
  ASSERT_EQ(program.matrix.cols(), 8);
  Eigen::VectorXd pulls(8);
  for (int k = 0; k < 8; ++k) pulls(k) = cables_[k].pull;
  const Wrench left = scaledWrench(pose_, tensions_);
  EXPECT_LT((program.matrix * pulls - program.wrench - left).norm(), 1e-6 * robot_.weight());
  EXPECT_LT((imbalance(problem_, pose_, cables_) - left).norm(), 1e-6 * robot_.weight());
  constexpr double kStep = 0.1;  // [N], of tensions near 1000
  for (int k = 0; k < 8; ++k) {
    std::vector<double> more = tensions_;
    std::vector<double> less = tensions_;
    more[k] += kStep;
    less[k] -= kStep;
    const Wrench slope = (scaledWrench(pose_, more) - scaledWrench(pose_, less)) / (2.0 * kStep);
    EXPECT_LT((program.matrix.col(k) / cables_[k].slope - slope).norm(), 1e-6) << k;
  }
}

// At constant pulls: the tensions move by what the cables' weight makes of the turn.
TEST_F(TensionProgram, ATurnTakesTheCablesAlongAtTheirPulls) {
  InverseRequest free;
  free.free_orientation = true;
  problem_.attitude = FreeAttitude(robot_, free);
  const std::optional<QuadraticProgram> program = attitudeProgram(problem_, pose_, cables_, {});
  ASSERT_TRUE(program.has_value());
  ASSERT_EQ(program->matrix.cols(), 11);
  constexpr double kStep = 1e-4;  // [rad]
  const auto turned = [&](const Eigen::Vector3d& turn) {
    std::vector<double> tensions;
    for (std::size_t i = 0; i < cables_.size(); ++i) {
      tensions.push_back(tensions_[i] + cables_[i].tensionByTurn() * turn);
    }
    return scaledWrench(displaced(pose_, Eigen::Vector3d::Zero(), turn), tensions);
  };
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d turn = kStep * Eigen::Vector3d::Unit(k);
    const Wrench slope = (turned(turn) - turned(-turn)) / (2.0 * kStep);
    EXPECT_LT((program->matrix.col(8 + k) - slope).norm(), 1e-5 * slope.norm()) << k;
  }
}

TEST_F(TensionProgram, LimitsAndPreferencesAreThoseOfTheTensions) {
  cables_[2].lower = 700.0;
  ASSERT_TRUE(cables_[2].linearise(robot_.cables[2], pose_, Steps::kNew, kTautInSearch));
  const TensionProblem program = tensionProgram(problem_, pose_, cables_, {});
  const auto tension = [&](int k, double pull) {
    return cables_[k].tension + cables_[k].slope * (pull - cables_[k].pull);
  };
  for (int k = 0; k < 8; ++k) {
    const CableDescription& cable = robot_.cables[k];
    // To the first order that a taut cable is known to; one step does not go all the way down to a far limit.
    if (k == 2) {
      EXPECT_NEAR(tension(k, program.lower(k)), 700.0, 1e-3 * tensions_[k]);
    } else {
      EXPECT_LT(tension(k, program.lower(k)), 0.5 * tensions_[k]) << k;
    }
    EXPECT_NEAR(tension(k, program.upper(k)), cable.tension_max, 1e-3 * cable.tension_max) << k;
    EXPECT_NEAR(tension(k, program.preferred(k)), problem_.preferred(k), 1e-3 * tensions_[k]) << k;
    EXPECT_NEAR(program.weight(k), cables_[k].slope / (cable.tension_max - cable.tension_min), 1e-6);
  }
}

// The cable's own step to another tension ends at its problem 3, to first order.
TEST_F(TensionProgram, ACableStepsToItsTension) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const CableSolution at = solvedAt(robot_.cables[i], pose_, tensions_[i] + 1.0);
    const Eigen::Vector3d change = cables_[i].change(cables_[i].pull + 1.0 / cables_[i].slope, Eigen::Vector3d::Zero());
    const SaggingCable& cable = cables_[i].cable;
    EXPECT_NEAR(cable.horizontalForce() + change.x(), at.horizontal_force, 1e-3);
    EXPECT_NEAR(cable.verticalForceA() + change.y(), at.vertical_force_a, 1e-3);
    EXPECT_NEAR(cable.length() + change.z(), at.length, 1e-3 * std::abs(change.z()) + 1e-9);
    EXPECT_LT(cables_[i].open, 1e-8);
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

// Folds of level catenaries against the closed form, and the sentence about limits that contradict each other.
#include "robot/tension_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kDistance = 4.0;  // [m]
constexpr double kWeight = 3.0;    // [N/m]

// T_A of an inextensible catenary between level ends is q a cosh(u), u = x/(2 a), least where u tanh(u) = 1.
double levelFold() {
  double u = 1.2;
  for (int i = 0; i < 50; ++i) u = 1.0 / std::tanh(u);
  return 0.5 * kWeight * kDistance / u * std::cosh(u);
}

RungOptions closedForm(Model model) {
  RungOptions options;
  options.model = model;
  options.limits.tolerance = 1e-10;
  return options;
}

class TensionLimits : public testing::Test {
 protected:
  TensionLimits() {
    robot_.cables.resize(1);
    CableDescription& cable = robot_.cables[0];
    cable.name = "level";
    cable.anchor.setZero();
    cable.attachment.setZero();
    cable.properties.axial_stiffness = 1e9;  // as good as inextensible
    cable.properties.bending_stiffness = 0.0;
    cable.properties.weight = kWeight;
    cable.tension_min = 1.0;
    cable.tension_max = 1000.0;
    pose_.position = {kDistance, 0.0, 0.0};
    cables_.resize(1);
    cables_[0].cable = SaggingCable(cable.properties, Model::kCatenary, 1e-10);
    cables_[0].plane = cablePlane(cable.anchor, cable.attachment, pose_);
    cables_[0].lower = cable.tension_min;
    cables_[0].upper = cable.tension_max;
  }

  const CableProperties& properties() const { return robot_.cables[0].properties; }

  // Hangs the cable at this length, linearised.
  void hang(double length) {
    ASSERT_TRUE(cables_[0].cable.startBetween(length, kDistance, 0.0, {}).ok());
    ASSERT_TRUE(cables_[0].linearise(robot_.cables[0], pose_, Steps::kNew));
  }

  RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  Pose pose_;
  std::vector<InverseCable> cables_;
  const RungOptions catenary_ = closedForm(Model::kCatenary);
};

TEST_F(TensionLimits, ATensionBelowTheFoldIsRaisedToJustAboveIt) {
  const CableSolution above = lengthAboveFold(properties(), 20.0, catenary_, &cables_[0]);
  ASSERT_TRUE(above.status.ok());
  EXPECT_NEAR(above.tension_a, 20.0, 1e-9);
  EXPECT_EQ(cables_[0].lower, 1.0) << "nothing to raise";
  const CableSolution raised = lengthAboveFold(properties(), 0.9 * levelFold(), catenary_, &cables_[0]);
  ASSERT_TRUE(raised.status.ok()) << raised.status.message;
  EXPECT_NEAR(cables_[0].lower, 1.001 * levelFold(), 1e-5 * levelFold());
  EXPECT_NEAR(raised.tension_a, cables_[0].lower, 1e-9);
}

TEST_F(TensionLimits, LimitsAreRaisedOnlyWhereATensionIsBelowTheFold) {
  EXPECT_FALSE(raiseLimitsToFolds(robot_, Eigen::VectorXd::Constant(1, 1.01 * levelFold()), catenary_, &cables_));
  EXPECT_EQ(cables_[0].lower, 1.0);
  EXPECT_TRUE(raiseLimitsToFolds(robot_, Eigen::VectorXd::Constant(1, 0.99 * levelFold()), catenary_, &cables_));
  EXPECT_NEAR(cables_[0].lower, 1.001 * levelFold(), 1e-5 * levelFold());
  EXPECT_FALSE(raiseLimitsToFolds(robot_, Eigen::VectorXd::Constant(1, 0.99 * levelFold()), catenary_, &cables_))
      << "it is there already";
}

TEST_F(TensionLimits, ACableBeyondItsFoldIsPulledBackToTheTautSide) {
  hang(1.05 * kDistance);
  EXPECT_FALSE(isBeyondFold(cables_[0], catenary_));
  EXPECT_FALSE(pullBackFromFolds(robot_, catenary_, &cables_));
  hang(1.8 * kDistance);  // the fold of level ends is at 1.2577 times their distance
  ASSERT_TRUE(isBeyondFold(cables_[0], catenary_));
  const double tension = cables_[0].cable.tensionA();
  EXPECT_TRUE(pullBackFromFolds(robot_, catenary_, &cables_));
  EXPECT_LT(cables_[0].cable.length(), 1.2577 * kDistance);
  EXPECT_NEAR(cables_[0].cable.tensionA(), tension, 1e-5 * tension);
}

TEST_F(TensionLimits, AStraightCableHasNoFold) {
  hang(1.8 * kDistance);
  EXPECT_TRUE(anyAtFold(cables_, Eigen::VectorXd::Constant(1, 2.0), catenary_));
  EXPECT_FALSE(anyAtFold(cables_, Eigen::VectorXd::Constant(1, 2.0), closedForm(Model::kStraightElastic)));
}

TEST_F(TensionLimits, ContradictionsNameCablesAndLimits) {
  TensionDistribution distribution;
  distribution.at_lower = {0, 3};  // the second is a free attitude's
  std::string text = contradiction(robot_, cables_, distribution).message;
  EXPECT_NE(text.find("'level' tension_min 1 N"), std::string::npos) << text;
  EXPECT_EQ(text.find(","), std::string::npos) << text;
  cables_[0].lower = 9.0;
  distribution.at_upper = {0};
  const Status status = contradiction(robot_, cables_, distribution);
  EXPECT_EQ(status.code, Code::kInfeasible);
  EXPECT_NE(status.message.find("'level' least tension that can hold the cable 9 N, 'level' tension_max 1000 N"),
            std::string::npos)
      << status.message;
}

}  // namespace
}  // namespace cdpr_kinetostatics

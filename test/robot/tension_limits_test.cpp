// The sentence about limits that contradict each other.
#include "robot/tension_limits.h"

#include <gtest/gtest.h>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

class TensionLimits : public testing::Test {
 protected:
  TensionLimits() {
    robot_.cables.resize(1);
    robot_.cables[0].name = "level";
    cables_.resize(1);
    cables_[0].lower = 1.0;
    cables_[0].upper = 1000.0;
  }

  std::string sentence() const { return contradiction(robot_, cables_, distribution_).message; }

  RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  std::vector<InverseCable> cables_;
  TensionDistribution distribution_;
};

TEST_F(TensionLimits, ContradictionsNameCablesAndLimits) {
  distribution_.at_lower = {0};
  EXPECT_NE(sentence().find("'level' tension_min 1 N"), std::string::npos) << sentence();
  EXPECT_EQ(sentence().find(","), std::string::npos) << sentence();
  cables_[0].at_fold = true;
  cables_[0].tension = 9.0;
  distribution_.at_upper = {0};
  EXPECT_EQ(contradiction(robot_, cables_, distribution_).code, Code::kInfeasible);
  EXPECT_NE(sentence().find("'level' least tension that can hold the cable 9 N, 'level' tension_max 1000 N"),
            std::string::npos)
      << sentence();
}

TEST_F(TensionLimits, ACableTooHeavyForItsLimitIsNamed) {
  cables_[0].too_heavy = true;
  cables_[0].tension = 1200.0;
  EXPECT_NE(sentence().find("'level' least tension that can hold the cable 1200 N, 'level' tension_max 1000 N"),
            std::string::npos)
      << sentence();
}

TEST_F(TensionLimits, NothingIsAnnouncedThatDoesNotFollow) {
  EXPECT_EQ(sentence().find(":"), std::string::npos) << sentence();
}

}  // namespace
}  // namespace cdpr_kinetostatics

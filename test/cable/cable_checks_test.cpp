// The form of a refusal, and where each limit lies. That every problem makes its checks is in invalid_input_test.
#include "cable/cable_checks.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace cdpr_kinetostatics {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expectRefused(const Status& status, const std::string& sentence) {
  EXPECT_EQ(status.code, Code::kInvalidInput);
  EXPECT_EQ(status.message, sentence);
}

TEST(Field, IsNamedAsItsUserKnowsIt) {
  const std::string cable = "north";
  EXPECT_EQ(Field("length").text(), "length");
  EXPECT_EQ(Field("pose", ".position.x").text(), "pose.position.x");
  EXPECT_EQ(Field("lengths", 3, cable).text(), "lengths[3] of cable 'north'");
}

TEST(CableChecks, SayFieldValueAndExpectation) {
  expectRefused(checkPositive("length", -2.5, 1e6, "m"),
                "length is -2.5 m: expected a positive number up to 1000000 m");
  expectRefused(checkLength("length", 1e-30), "length is 1e-30 m: expected 1e-06 m to 1000000 m");
  expectRefused(checkZeroOrBetween("weight", 1e-30, 0.5, 2.0, "N/m"),
                "weight is 1e-30 N/m: expected 0, or 0.5 N/m to 2 N/m");
  expectRefused(checkNotNegative("tension", -1.0, 50.0, "N"), "tension is -1 N: expected 0 to 50 N");
  expectRefused(checkWithin("share", 3.0, 2.0, ""), "share is 3: expected a finite number of magnitude up to 2");
  expectRefused(checkTolerance("tolerance", 0.2), "tolerance is 0.2: expected 1e-13 to 0.1");
  expectRefused(checkProfilePoints("profile_points", 1, 30), "profile_points is 1: expected 0 (no profile) or 2 to 30");
}

TEST(CableChecks, IncludeTheirLimits) {
  EXPECT_TRUE(checkWithin("a", -2.0, 2.0, "m").ok());
  EXPECT_FALSE(checkWithin("a", -2.0000001, 2.0, "m").ok());
  EXPECT_TRUE(checkNotNegative("a", 0.0, 2.0, "m").ok());
  EXPECT_FALSE(checkPositive("a", 0.0, 2.0, "m").ok());
  EXPECT_TRUE(checkPositive("a", 2.0, 2.0, "m").ok());
  EXPECT_TRUE(checkTolerance("a", kFinestTolerance).ok());
  EXPECT_TRUE(checkTolerance("a", kCoarsestTolerance).ok());
  EXPECT_TRUE(checkProfilePoints("a", 0).ok());
  EXPECT_TRUE(checkProfilePoints("a", 2).ok());
  EXPECT_TRUE(checkProfilePoints("a", kMostProfilePoints).ok());
  EXPECT_FALSE(checkProfilePoints("a", kMostProfilePoints + 1).ok());
}

TEST(CableChecks, RefuseWhatIsNoNumber) {
  for (const double bad : {kNaN, kInfinity}) {
    EXPECT_FALSE(checkWithin("a", bad, 2.0, "m").ok());
    EXPECT_FALSE(checkNotNegative("a", bad, 2.0, "m").ok());
    EXPECT_FALSE(checkPositive("a", bad, 2.0, "m").ok());
    EXPECT_FALSE(checkTolerance("a", bad).ok());
    EXPECT_FALSE(checkAccuracy("a", bad).ok());
  }
}

TEST(CableChecks, OnlyModelsThatStretchNeedAnAxialStiffness) {
  EXPECT_TRUE(checkAxialStiffness(0.0, Model::kCatenaryInextensible).ok());
  EXPECT_TRUE(checkAxialStiffness(kInfinity, Model::kCatenary).ok());
  const Status status = checkAxialStiffness(0.0, Model::kBending);
  EXPECT_NE(status.message.find("axial_stiffness is 0 N"), std::string::npos) << status.message;
  EXPECT_NE(status.message.find("the model bending"), std::string::npos) << status.message;
}

TEST(CableChecks, TheFirstRefusalCounts) {
  expectRefused(firstRefusal(checkPositive("a", 1.0, 2.0, ""), checkPositive("b", -1.0, 2.0, ""),
                             checkPositive("c", -1.0, 2.0, "")),
                "b is -1: expected a positive number up to 2");
  EXPECT_TRUE(firstRefusal(checkPositive("a", 1.0, 2.0, "")).ok());
}

TEST(CableChecks, EndsOfACableAreApart) {
  EXPECT_TRUE(checkEndsApart(0.0, -1e-9).ok());
  expectRefused(checkEndsApart(0.0, 0.0),
                "x and y are both 0 m: expected the ends of the cable apart, for a length to span");
}

}  // namespace
}  // namespace cdpr_kinetostatics

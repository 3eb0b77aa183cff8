#include "ros/conversions.h"

#include <gtest/gtest.h>

#include "yaml_parameters.h"

namespace cdpr_kinetostatics {
namespace {

TEST(Conversions, PosesComeBack) {
  const Pose pose{{1.0, -2.0, 3.0}, Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5)};
  const Pose back = fromMsg(toMsg(pose));
  EXPECT_EQ(back.position, pose.position);
  EXPECT_EQ(back.orientation.coeffs(), pose.orientation.coeffs());
}

TEST(Conversions, QuaternionsAreNormalised) {
  geometry_msgs::Pose pose;
  pose.orientation.x = 0.3;
  pose.orientation.w = 0.4;
  EXPECT_NEAR(fromMsg(pose).orientation.x(), 0.6, 1e-15);
  EXPECT_NEAR(fromMsg(pose).orientation.w(), 0.8, 1e-15);
}

TEST(Conversions, WrenchesAreForceThenTorque) {
  geometry_msgs::Wrench wrench;
  wrench.force.y = 2.0;
  wrench.torque.x = 4.0;
  EXPECT_EQ(fromMsg(wrench), (Wrench() << 0.0, 2.0, 0.0, 4.0, 0.0, 0.0).finished());
}

TEST(Conversions, MatricesAreRowMajor) {
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  matrix(1, 4) = 7.0;
  const std::vector<double> numbers = toMsg(matrix);
  ASSERT_EQ(numbers.size(), 36u);
  EXPECT_EQ(numbers[10], 7.0);
}

TEST(Conversions, CodesAndModelsAreThoseOfTheMessages) {
  EXPECT_EQ(toMsg(Status{Code::kConverged, ""}).code, SolveReport::CONVERGED);
  EXPECT_EQ(toMsg(Status{Code::kNotConverged, ""}).code, SolveReport::NOT_CONVERGED);
  EXPECT_EQ(toMsg(Status{Code::kTimedOut, ""}).code, SolveReport::TIMED_OUT);
  EXPECT_EQ(toMsg(Status{Code::kInvalidInput, ""}).code, SolveReport::INVALID_INPUT);
  EXPECT_EQ(toMsg(Status{Code::kInfeasible, ""}).code, SolveReport::INFEASIBLE);
  EXPECT_EQ(toMsg(Status{Code::kWrongBranch, ""}).code, SolveReport::WRONG_BRANCH);
  EXPECT_EQ(toMsg(Status{Code::kUnknownCable, ""}).code, SolveReport::UNKNOWN_CABLE);
  EXPECT_EQ(toMsg(Status{Code::kInternalError, ""}).code, SolveReport::INTERNAL_ERROR);
  EXPECT_EQ(toMsg(Status{Code::kInfeasible, "too heavy"}).message, "too heavy");
}

TEST(Conversions, ACableAlonePullsItsEndTowardsItsStart) {
  CableSolution solution;
  solution.length = 10.0;
  solution.horizontal_force = 30.0;
  solution.vertical_force_a = 12.0;
  solution.vertical_force_b = 12.0 - 2.0 * 10.0;  // of 2 N/m
  solution.wrap_angle = 1.25;
  solution.departure_x = 0.03;
  solution.departure_y = 0.04;
  solution.profile.resize(2);
  solution.profile[1].x = 8.0;
  solution.profile[1].y = -1.0;
  const CableState state = toMsg(solution, "rope", Condition::kSlack);
  EXPECT_EQ(state.name, "rope");
  EXPECT_EQ(state.condition, CableState::SLACK);
  // At B: (-H, V - q L).
  EXPECT_EQ(state.force_on_platform.x, -30.0);
  EXPECT_EQ(state.force_on_platform.y, 0.0);
  EXPECT_EQ(state.force_on_platform.z, 12.0 - 2.0 * 10.0);
  EXPECT_EQ(state.wrap_angle, 1.25);
  EXPECT_EQ(state.departure.x, 0.03);
  EXPECT_EQ(state.departure.y, 0.0);
  EXPECT_EQ(state.departure.z, 0.04);
  EXPECT_EQ(state.profile[1].x, 8.0);
  EXPECT_EQ(state.profile[1].z, -1.0);
}

TEST(Conversions, ParametersBecomeTheYamlThatTheyWereLoadedFrom) {
  const YAML::Node yaml = YAML::Load("{a: 1, b: 2.5, c: true, d: word, e: [1, {f: 3}]}");
  const YAML::Node back = toYaml(toParameter(yaml));
  EXPECT_EQ(back["a"].as<int>(), 1);
  EXPECT_EQ(back["b"].as<double>(), 2.5);
  EXPECT_TRUE(back["c"].as<bool>());
  EXPECT_EQ(back["d"].as<std::string>(), "word");
  EXPECT_EQ(back["e"][1]["f"].as<int>(), 3);
}

TEST(Conversions, DatesAreNoParameters) {
  std::tm date{};
  EXPECT_THROW(toYaml(XmlRpc::XmlRpcValue(&date)), std::invalid_argument);
}

}  // namespace
}  // namespace cdpr_kinetostatics

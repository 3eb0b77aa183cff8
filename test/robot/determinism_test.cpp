// The answer depends on the request alone: not on earlier solves, nor on what other threads do.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <thread>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

// All numbers of a solution but its time.
std::vector<double> numbers(const RobotSolution& s) {
  std::vector<double> result = {static_cast<double>(s.report.status.code), static_cast<double>(s.report.iterations),
                                s.report.closure_residual, s.report.force_residual, s.report.moment_residual};
  const auto append = [&](const auto& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) result.push_back(values.data()[i]);
  };
  append(s.pose.position);
  append(s.pose.orientation.coeffs());
  append(s.stiffness);
  for (const CableResult& r : s.cables) {
    append(r.force_on_platform);
    for (const double value : {r.cable.length, r.cable.horizontal_force, r.cable.vertical_force_a, r.cable.angle_a,
                               r.cable.sag, r.cable.max_moment, r.cable.max_shear}) {
      result.push_back(value);
    }
    for (const Eigen::Vector3d& point : r.profile) append(point);
  }
  return result;
}

void expectBitwiseEqual(const RobotSolution& a, const RobotSolution& b) {
  const std::vector<double> x = numbers(a);
  const std::vector<double> y = numbers(b);
  ASSERT_EQ(x.size(), y.size());
  EXPECT_EQ(std::memcmp(x.data(), y.data(), x.size() * sizeof(double)), 0);
}

class Determinism : public testing::TestWithParam<std::tuple<const char*, Model>> {
 protected:
  Determinism() {
    options_ = patient(std::get<1>(GetParam()));
    options_.profile_points = 9;
    options_.compute_stiffness = true;
    inverse_ = requestFor(robot_, robot_.home);
    Dice dice(91);
    const RobotSolution solution = solveInverse(robot_, inverse_, options_);
    EXPECT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    forward_.lengths = lengthsOf(solution);
    forward_.seed = dice.away(robot_.home, 0.01 * robot_.span(), 0.05);
    if (robot_.type == PlatformType::kPointMass) forward_.seed->orientation = robot_.home.orientation;
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, std::get<0>(GetParam()));
  RobotSolverOptions options_;
  ForwardRequest forward_;
  InverseRequest inverse_;
};

TEST_P(Determinism, TheSameRequestTwiceGivesTheSameBits) {
  const RobotSolution forward = solveForward(robot_, forward_, options_);
  const RobotSolution inverse = solveInverse(robot_, inverse_, options_);
  ASSERT_TRUE(forward.report.status.ok()) << forward.report.status.message;
  ASSERT_TRUE(inverse.report.status.ok()) << inverse.report.status.message;
  expectBitwiseEqual(forward, solveForward(robot_, forward_, options_));
  expectBitwiseEqual(inverse, solveInverse(robot_, inverse_, options_));
}

TEST_P(Determinism, SolvesInTwoThreadsDoNotDisturbEachOther) {
  const RobotSolution forward = solveForward(robot_, forward_, options_);
  const RobotSolution inverse = solveInverse(robot_, inverse_, options_);
  std::vector<RobotSolution> forwards(3), inverses(3);
  std::thread one([&] {
    for (RobotSolution& solution : forwards) solution = solveForward(robot_, forward_, options_);
  });
  std::thread two([&] {
    for (RobotSolution& solution : inverses) solution = solveInverse(robot_, inverse_, options_);
  });
  one.join();
  two.join();
  for (const RobotSolution& solution : forwards) expectBitwiseEqual(solution, forward);
  for (const RobotSolution& solution : inverses) expectBitwiseEqual(solution, inverse);
}

INSTANTIATE_TEST_SUITE_P(Robots, Determinism,
                         testing::Combine(testing::Values("cogiro", "desktop_music_wire", "scampi", "paper_point_mass"),
                                          testing::Values(Model::kStraightElastic, Model::kCatenary, Model::kBending)),
                         [](const testing::TestParamInfo<std::tuple<const char*, Model>>& each) {
                           return std::string(std::get<0>(each.param)) + "_" + modelName(std::get<1>(each.param));
                         });

}  // namespace
}  // namespace cdpr_kinetostatics

// Scale invariance: a robot in other units of length and force has the same answers in those units. A dimensional
// constant in the code would break it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <tuple>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"
#include "scaled_robot.h"

namespace cdpr_kinetostatics {
namespace {

constexpr Model kModels[] = {
    Model::kAuto,     Model::kStraight,          Model::kStraightElastic,     Model::kCatenaryInextensible,
    Model::kCatenary, Model::kCatenaryCorrected, Model::kBendingInextensible, Model::kBending};

// Powers of two leave every digit in place; other factors round.
const std::vector<Scale> kExact = {{1024.0, 1.0}, {1.0, 1.0 / 1024.0}, {1.0 / 1024.0, 4096.0}, {0.25, 1024.0}};
const std::vector<Scale> kRounded = {{1e-3, 1e3}, {1e3, 1e-3}, {1e3, 1e3}, {1e-3, 1e-3}, {7.0, 0.3}};

struct Difference {
  double pose = 0.0;     // over the span, and [rad]
  double tension = 0.0;  // over the largest tension
  double length = 0.0;   // over the length
};

// Between a solution and the same one in other units; also the codes and the rungs must agree.
Difference differenceOf(const RobotDescription& robot, const RobotSolution& own, const Scale& scale,
                        const RobotSolution& other) {
  Difference d;
  EXPECT_EQ(own.report.status.code, other.report.status.code) << other.report.status.message;
  EXPECT_EQ(own.cables.size(), other.cables.size());
  if (!own.report.status.ok() || !other.report.status.ok()) return d;
  d.pose = std::max((own.pose.position - other.pose.position / scale.length).norm() / robot.span(),
                    own.pose.orientation.angularDistance(other.pose.orientation));
  double largest = 0.0;
  for (const double tension : tensionsOf(own)) largest = std::max(largest, tension);
  for (std::size_t i = 0; i < own.cables.size(); ++i) {
    const CableSolution& a = own.cables[i].cable;
    const CableSolution& b = other.cables[i].cable;
    EXPECT_EQ(a.model, b.model) << "cable " << i;
    d.tension = std::max(d.tension, std::abs(a.tension_a - b.tension_a / scale.force) / largest);
    d.length = std::max(d.length, std::abs(a.length - b.length / scale.length) / a.length);
  }
  return d;
}

class RobotScale : public testing::TestWithParam<std::tuple<std::string, Model>> {
 protected:
  void expectTheSameInOtherUnits(const std::vector<Scale>& scales, double tolerance);
};

void RobotScale::expectTheSameInOtherUnits(const std::vector<Scale>& scales, double tolerance) {
  const std::string& name = std::get<0>(GetParam());
  const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
  RobotSolverOptions options = patient(std::get<1>(GetParam()));
  const Workspace workspace = workspaceOf(name);
  Dice dice(31);
  Difference worst;
  for (int k = 0; k < 3; ++k) {
    InverseRequest request = requestFor(robot, randomPose(workspace, &dice));
    request.external_wrench(2) = -0.05 * robot.weight();
    if (robot.type == PlatformType::kRigidBody) request.external_wrench(4) = 1e-3 * robot.weight() * robot.span();
    const RobotSolution inverse = solveInverse(robot, request, options);
    ForwardRequest back;
    back.external_wrench = request.external_wrench;
    if (inverse.report.status.ok()) {
      back.lengths = lengthsOf(inverse);
      back.seed = dice.away(inverse.pose, 0.02 * robot.span(), robot.freedoms() == 6 ? 0.1 : 0.0);
    }
    const RobotSolution forward = solveForward(robot, back, options);
    for (const Scale& scale : scales) {
      SCOPED_TRACE(testing::Message() << "pose " << k << ", lengths times " << scale.length << ", forces times "
                                      << scale.force);
      const RobotDescription other = scaled(scale, robot);
      const RobotSolverOptions other_options = scaled(scale, options);
      const Difference d =
          differenceOf(robot, inverse, scale, solveInverse(other, scaled(scale, request), other_options));
      const Difference e = differenceOf(robot, forward, scale, solveForward(other, scaled(scale, back), other_options));
      worst.pose = std::max({worst.pose, d.pose, e.pose});
      worst.length = std::max({worst.length, d.length, e.length});
      worst.tension = std::max({worst.tension, d.tension, e.tension});
    }
  }
  std::cout << name << " " << modelName(options.model) << ": pose " << worst.pose << " tension " << worst.tension
            << " length " << worst.length << "\n";
  EXPECT_LE(worst.pose, tolerance);
  EXPECT_LE(worst.tension, tolerance);
  EXPECT_LE(worst.length, tolerance);
}

TEST_P(RobotScale, PowersOfTwoChangeNoDigit) { expectTheSameInOtherUnits(kExact, 0.0); }

TEST_P(RobotScale, OtherFactorsChangeOnlyRounding) { expectTheSameInOtherUnits(kRounded, 1e-8); }

INSTANTIATE_TEST_SUITE_P(All, RobotScale,
                         testing::Combine(testing::Values("cogiro", "caroca", "ipanema3", "desktop_music_wire", "fast",
                                                          "scampi", "paper_point_mass"),
                                          testing::ValuesIn(kModels)),
                         [](const testing::TestParamInfo<std::tuple<std::string, Model>>& each) {
                           return std::get<0>(each.param) + "_" + modelName(std::get<1>(each.param));
                         });

}  // namespace
}  // namespace cdpr_kinetostatics

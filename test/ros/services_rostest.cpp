// Each service on four robots: redundant, desktop size, under-constrained, point mass.
//
// Answers are judged by independent summation of forces and by undoing one service with another.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <future>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "node_client.h"
#include "ros/conversions.h"

namespace cdpr_kinetostatics {
namespace {

using Eigen::Vector3d;

constexpr double kTimeout = 20.0;  // [s], ample for a busy machine

Vector3d toEigen(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }
Vector3d toEigen(const geometry_msgs::Point& p) { return {p.x, p.y, p.z}; }

class Services : public testing::TestWithParam<const char*> {
 protected:
  Services()
      : robot_(loadRobotFile(std::string(ROBOT_DIR) + "/" + GetParam() + ".yaml").robot),
        node_(std::string("/") + GetParam()) {}

  // A pose near home, in the plane of the point mass' cables.
  InverseKinetostatics::Request inverseRequest() const {
    InverseKinetostatics::Request request;
    Pose pose = robot_.home;
    pose.position.x() += 0.01 * robot_.span();
    request.pose = toMsg(pose);
    request.options.model = SolverOptions::BENDING;
    request.free_orientation = robot_.freedoms() == 6 && robot_.cables.size() < 6;
    request.options.timeout = ros::Duration(kTimeout);
    return request;
  }

  static ForwardKinetostatics::Request forwardRequest(const std::vector<double>& lengths) {
    ForwardKinetostatics::Request request;
    request.lengths = lengths;
    request.options.model = SolverOptions::BENDING;
    request.options.timeout = ros::Duration(kTimeout);
    return request;
  }

  // Largest force and moment left over, with the load and the platform's weight.
  void expectEquilibrium(const geometry_msgs::Pose& reached, const std::vector<CableState>& cables,
                         const Wrench& load) const {
    const Pose pose = fromMsg(reached);
    const Vector3d weight(0.0, 0.0, -robot_.weight());
    Vector3d force = load.head<3>() + weight;
    Vector3d moment = load.tail<3>() + (pose.orientation * robot_.com).cross(weight);
    double scale = robot_.weight();
    ASSERT_EQ(cables.size(), robot_.cables.size());
    for (std::size_t i = 0; i < cables.size(); ++i) {
      const Vector3d pull = toEigen(cables[i].force_on_platform);
      force += pull;
      moment += (pose.orientation * robot_.cables[i].attachment).cross(pull);
      scale = std::max(scale, cables[i].tension_a);
    }
    EXPECT_LT(force.norm(), 1e-6 * scale);
    if (robot_.freedoms() == 6) {
      EXPECT_LT(moment.norm(), 1e-6 * scale * robot_.platformRadius());
    }
  }

  void expectSamePose(const geometry_msgs::Pose& a, const geometry_msgs::Pose& b) const {
    EXPECT_LT((fromMsg(a).position - fromMsg(b).position).norm(), 1e-6 * robot_.span());
    if (robot_.freedoms() == 6) {
      EXPECT_LT(fromMsg(a).orientation.angularDistance(fromMsg(b).orientation), 1e-5);
    }
  }

  RobotDescription robot_;
  NodeClient node_;
};

TEST_P(Services, InverseBalancesWithinTheLimits) {
  InverseKinetostatics::Request request = inverseRequest();
  const InverseKinetostatics::Response answer = node_.inverse(request);
  ASSERT_EQ(answer.report.code, SolveReport::CONVERGED) << answer.report.message;
  EXPECT_EQ(answer.report.model, SolverOptions::BENDING);
  EXPECT_FALSE(answer.report.warm_started);
  EXPECT_GT(answer.report.solve_time, 0.0);
  expectEquilibrium(answer.pose, answer.cables, Wrench::Zero());
  ASSERT_EQ(answer.lengths.size(), robot_.cables.size());
  for (std::size_t i = 0; i < answer.cables.size(); ++i) {
    const CableState& cable = answer.cables[i];
    EXPECT_EQ(cable.name, robot_.cables[i].name);
    EXPECT_EQ(cable.length, answer.lengths[i]);
    EXPECT_GE(cable.tension_a, robot_.cables[i].tension_min * (1.0 - 1e-6));
    EXPECT_LE(cable.tension_a, robot_.cables[i].tension_max * (1.0 + 1e-6));
    EXPECT_TRUE(cable.profile.empty());
  }
}

TEST_P(Services, ForwardUndoesInverse) {
  const InverseKinetostatics::Response inverse = node_.inverse(inverseRequest());
  ASSERT_EQ(inverse.report.code, SolveReport::CONVERGED) << inverse.report.message;
  const ForwardKinetostatics::Response forward = node_.forward(forwardRequest(inverse.lengths));
  ASSERT_EQ(forward.report.code, SolveReport::CONVERGED) << forward.report.message;
  expectSamePose(forward.pose, inverse.pose);
  expectEquilibrium(forward.pose, forward.cables, Wrench::Zero());
  for (std::size_t i = 0; i < forward.cables.size(); ++i) {
    const double tension = inverse.cables[i].tension_a;
    EXPECT_NEAR(forward.cables[i].tension_a, tension, 1e-4 * tension);
  }
}

TEST_P(Services, LoadIsCarried) {
  InverseKinetostatics::Request request = inverseRequest();
  request.external_wrench.force.x = 0.02 * robot_.weight();
  request.external_wrench.force.z = -0.1 * robot_.weight();
  const InverseKinetostatics::Response inverse = node_.inverse(request);
  ASSERT_EQ(inverse.report.code, SolveReport::CONVERGED) << inverse.report.message;
  expectEquilibrium(inverse.pose, inverse.cables, fromMsg(request.external_wrench));

  ForwardKinetostatics::Request back = forwardRequest(inverse.lengths);
  back.external_wrench = request.external_wrench;
  const ForwardKinetostatics::Response forward = node_.forward(back);
  ASSERT_EQ(forward.report.code, SolveReport::CONVERGED) << forward.report.message;
  expectSamePose(forward.pose, inverse.pose);
}

TEST_P(Services, CablesMayComeInAnyOrder) {
  const InverseKinetostatics::Response inverse = node_.inverse(inverseRequest());
  ASSERT_EQ(inverse.report.code, SolveReport::CONVERGED) << inverse.report.message;
  ForwardKinetostatics::Request request = forwardRequest(inverse.lengths);
  const ForwardKinetostatics::Response in_order = node_.forward(request);
  for (const CableDescription& cable : robot_.cables) request.cable_names.push_back(cable.name);
  std::reverse(request.lengths.begin(), request.lengths.end());
  std::reverse(request.cable_names.begin(), request.cable_names.end());
  const ForwardKinetostatics::Response reversed = node_.forward(request);
  ASSERT_EQ(reversed.report.code, SolveReport::CONVERGED) << reversed.report.message;
  EXPECT_EQ(reversed.pose, in_order.pose);
  EXPECT_EQ(reversed.cables, in_order.cables);
}

TEST_P(Services, ProfilesRunFromAnchorToAttachment) {
  InverseKinetostatics::Request request = inverseRequest();
  request.profile_points = 11;
  const InverseKinetostatics::Response answer = node_.inverse(request);
  ASSERT_EQ(answer.report.code, SolveReport::CONVERGED) << answer.report.message;
  const Pose pose = fromMsg(answer.pose);
  for (std::size_t i = 0; i < answer.cables.size(); ++i) {
    const auto& profile = answer.cables[i].profile;
    ASSERT_EQ(profile.size(), 11u);
    EXPECT_LT((toEigen(profile.front()) - robot_.cables[i].anchor).norm(), 1e-9 * robot_.span());
    EXPECT_LT((toEigen(profile.back()) - pose.transform(robot_.cables[i].attachment)).norm(), 1e-6 * robot_.span());
  }
}

TEST_P(Services, StiffnessIsThatOfAStablePlatform) {
  const InverseKinetostatics::Response inverse = node_.inverse(inverseRequest());
  ASSERT_EQ(inverse.report.code, SolveReport::CONVERGED) << inverse.report.message;
  ForwardKinetostatics::Request request = forwardRequest(inverse.lengths);
  EXPECT_TRUE(node_.forward(request).stiffness.empty());
  request.compute_stiffness = true;
  const ForwardKinetostatics::Response answer = node_.forward(request);
  ASSERT_EQ(answer.stiffness.size(), 36u);
  using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const Matrix6 stiffness = Eigen::Map<const Matrix6>(answer.stiffness.data());
  const int n = robot_.freedoms();
  const Eigen::MatrixXd symmetric = (stiffness + stiffness.transpose()).topLeftCorner(n, n) / 2.0;
  EXPECT_LT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues().maxCoeff(), 0.0);
  if (n == 3) {
    EXPECT_EQ(stiffness.bottomRows<3>().norm(), 0.0);
    EXPECT_EQ(stiffness.rightCols<3>().norm(), 0.0);
  }
}

TEST_P(Services, CableAloneAgreesWithCableOfTheRobot) {
  const InverseKinetostatics::Response inverse = node_.inverse(inverseRequest());
  ASSERT_EQ(inverse.report.code, SolveReport::CONVERGED) << inverse.report.message;
  const CableState& cable = inverse.cables[0];
  const Vector3d chord = fromMsg(inverse.pose).transform(robot_.cables[0].attachment) - robot_.cables[0].anchor;

  SolveCable::Request request;
  request.options.timeout = ros::Duration(kTimeout);
  request.options.model = cable.model;
  request.cable_name = cable.name;
  request.x = chord.head<2>().norm();
  request.y = chord.z();
  request.length = cable.length;
  request.horizontal_force = cable.horizontal_force;
  request.vertical_force_a = cable.vertical_force_a;
  request.tension_a = cable.tension_a;
  for (const std::uint8_t problem :
       {SolveCable::Request::FIND_POSITION, SolveCable::Request::FIND_FORCES, SolveCable::Request::FIND_LENGTH}) {
    request.problem = problem;
    const SolveCable::Response answer = node_.cable(request);
    ASSERT_EQ(answer.report.code, SolveReport::CONVERGED) << answer.report.message;
    EXPECT_EQ(answer.cable.name, cable.name);
    EXPECT_NEAR(answer.x, request.x, 1e-6 * cable.length);
    EXPECT_NEAR(answer.y, request.y, 1e-6 * cable.length);
    EXPECT_NEAR(answer.cable.length, cable.length, 1e-6 * cable.length);
    EXPECT_NEAR(answer.cable.horizontal_force, cable.horizontal_force, 1e-4 * cable.tension_a);
    EXPECT_NEAR(answer.cable.vertical_force_a, cable.vertical_force_a, 1e-4 * cable.tension_a);
    EXPECT_NEAR(answer.cable.force_on_platform.z, cable.force_on_platform.z, 1e-4 * cable.tension_a);
    EXPECT_EQ(answer.cable.condition, cable.condition);
  }
}

TEST_P(Services, SameRequestSameAnswerAlsoAtTheSameTime) {
  const InverseKinetostatics::Request request = inverseRequest();
  const InverseKinetostatics::Response first = node_.inverse(request);
  std::vector<std::future<InverseKinetostatics::Response>> others;
  for (int i = 0; i < 8; ++i) {
    others.push_back(std::async(std::launch::async, [&] { return node_.inverse(request); }));
  }
  for (auto& other : others) {
    const InverseKinetostatics::Response answer = other.get();
    EXPECT_EQ(answer.report.code, first.report.code) << answer.report.message;
    EXPECT_EQ(answer.report.iterations, first.report.iterations);
    EXPECT_EQ(answer.pose, first.pose);
    EXPECT_EQ(answer.lengths, first.lengths);
    EXPECT_EQ(answer.cables, first.cables);
  }
}

TEST_P(Services, EveryModelAnswers) {
  for (const std::uint8_t model :
       {SolverOptions::STRAIGHT, SolverOptions::STRAIGHT_ELASTIC, SolverOptions::CATENARY_INEXTENSIBLE,
        SolverOptions::CATENARY, SolverOptions::CATENARY_CORRECTED, SolverOptions::BENDING_INEXTENSIBLE,
        SolverOptions::BENDING}) {
    InverseKinetostatics::Request request = inverseRequest();
    request.options.model = model;
    const InverseKinetostatics::Response inverse = node_.inverse(request);
    if (model == SolverOptions::CATENARY_CORRECTED && inverse.report.code == SolveReport::NOT_CONVERGED) {
      EXPECT_NE(inverse.report.message.find("bending"), std::string::npos) << inverse.report.message;
      continue;  // bars bend by more than a first-order effect
    }
    ASSERT_EQ(inverse.report.code, SolveReport::CONVERGED) << int{model} << ": " << inverse.report.message;
    EXPECT_EQ(inverse.report.model, model);
    expectEquilibrium(inverse.pose, inverse.cables, Wrench::Zero());
    ForwardKinetostatics::Request back = forwardRequest(inverse.lengths);
    back.options.model = model;
    const ForwardKinetostatics::Response forward = node_.forward(back);
    ASSERT_EQ(forward.report.code, SolveReport::CONVERGED) << int{model} << ": " << forward.report.message;
    expectSamePose(forward.pose, inverse.pose);
  }
}

// The node's own model is auto, its accuracy 1e-4 m.
TEST_P(Services, AutoStaysWithinTheAccuracyAskedFor) {
  for (const double accuracy : {0.0, 1e-2, 1e-6}) {
    const double allowed = accuracy > 0.0 ? accuracy : 1e-4;
    InverseKinetostatics::Request request = inverseRequest();
    request.options.model = accuracy > 0.0 ? SolverOptions::AUTO : SolverOptions::MODEL_DEFAULT;
    request.options.accuracy = accuracy;
    const InverseKinetostatics::Response inverse = node_.inverse(request);
    ASSERT_EQ(inverse.report.code, SolveReport::CONVERGED) << inverse.report.message;
    EXPECT_LE(inverse.report.estimated_error, allowed);
    EXPECT_NE(inverse.report.message.find("cable"), std::string::npos) << inverse.report.message;
    ForwardKinetostatics::Request finest = forwardRequest(inverse.lengths);
    finest.seed = inverse.pose;
    finest.use_seed = true;
    const ForwardKinetostatics::Response applied = node_.forward(finest);
    ASSERT_EQ(applied.report.code, SolveReport::CONVERGED) << applied.report.message;
    EXPECT_LE((fromMsg(applied.pose).position - fromMsg(inverse.pose).position).norm(), allowed);
    ForwardKinetostatics::Request back = finest;
    back.options.model = request.options.model;
    back.options.accuracy = accuracy;
    const ForwardKinetostatics::Response forward = node_.forward(back);
    ASSERT_EQ(forward.report.code, SolveReport::CONVERGED) << forward.report.message;
    EXPECT_LE((fromMsg(applied.pose).position - fromMsg(forward.pose).position).norm(), allowed);
    for (const CableState& cable : forward.cables) EXPECT_LE(cable.model, forward.report.model);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Services,
                         testing::Values("cogiro", "desktop_music_wire", "scampi", "paper_point_mass"),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ros_services_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

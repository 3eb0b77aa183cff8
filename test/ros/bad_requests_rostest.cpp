// Whatever is wrong with a request: a code, a sentence that names it, finite numbers, and a node that lives on.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <functional>
#include <limits>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "node_client.h"
#include "ros/conversions.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const RobotDescription& cogiro() {
  static const RobotDescription robot = loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot;
  return robot;
}

template <typename Service>
struct Case {
  const char* what;
  std::function<void(typename Service::Request&)> spoil;
  std::vector<std::string> named;  // words of the sentence
  std::int32_t code = SolveReport::INVALID_INPUT;
};

template <typename Service, typename Call>
void expectRefused(const Case<Service>& wrong, typename Service::Request request, const Call& call) {
  SCOPED_TRACE(wrong.what);
  wrong.spoil(request);
  const typename Service::Response response = call(request);
  EXPECT_EQ(response.report.code, wrong.code) << response.report.message;
  for (const std::string& word : wrong.named) {
    EXPECT_NE(response.report.message.find(word), std::string::npos) << response.report.message;
  }
  EXPECT_TRUE(isFinite(response));
}

template <typename Service>
std::vector<Case<Service>> wrongOptions() {
  using Request = typename Service::Request;
  return {
      {"no such model", [](Request& r) { r.options.model = 200; }, {"options.model", "200"}},
      {"negative accuracy", [](Request& r) { r.options.accuracy = -1e-3; }, {"options.accuracy", "-0.001"}},
      {"accuracy NaN", [](Request& r) { r.options.accuracy = kNan; }, {"options.accuracy", "nan"}},
      {"negative tolerance", [](Request& r) { r.options.tolerance = -1e-8; }, {"options.tolerance", "-1e-08"}},
      {"tolerance NaN", [](Request& r) { r.options.tolerance = kNan; }, {"options.tolerance", "nan"}},
      {"tolerance too small", [](Request& r) { r.options.tolerance = 1e-20; }, {"options.tolerance", "1e-20"}},
      {"tolerance too large", [](Request& r) { r.options.tolerance = 2.0; }, {"options.tolerance", "2"}},
      {"negative timeout", [](Request& r) { r.options.timeout = ros::Duration(-1.0); }, {"options.timeout", "-1 s"}},
      {"timeout too long",
       [](Request& r) { r.options.timeout = ros::Duration(1e6); },
       {"options.timeout", "1000000 s"}},
      {"one profile point", [](Request& r) { r.profile_points = 1; }, {"profile_points", "1"}},
      {"negative profile points", [](Request& r) { r.profile_points = -5; }, {"profile_points", "-5"}},
      {"two thousand million profile points",
       [](Request& r) { r.profile_points = std::numeric_limits<std::int32_t>::max(); },
       {"profile_points", "2147483647"}},
  };
}

template <typename Service>
std::vector<Case<Service>> wrongWrenches() {
  using Request = typename Service::Request;
  return {
      {"force NaN", [](Request& r) { r.external_wrench.force.y = kNan; }, {"external_wrench.force.y", "nan"}},
      {"torque infinite",
       [](Request& r) { r.external_wrench.torque.z = kInfinity; },
       {"external_wrench.torque.z", "inf"}},
      {"absurd force", [](Request& r) { r.external_wrench.force.x = -1e13; }, {"external_wrench.force.x", "-1e+13"}},
  };
}

class BadRequests : public testing::Test {
 protected:
  BadRequests() {
    inverse_request_.pose = toMsg(cogiro().home);
    inverse_request_.options.timeout = ros::Duration(20.0);
    for (const CableDescription& cable : cogiro().cables) {
      const Eigen::Vector3d end = cogiro().home.transform(cable.attachment);
      forward_request_.lengths.push_back((end - cable.anchor).norm());
    }
    cable_request_.problem = SolveCable::Request::FIND_FORCES;
    cable_request_.x = 8.0;
    cable_request_.y = -4.0;
    cable_request_.length = 8.95;
    cable_request_.axial_stiffness = 2.87e5;
    cable_request_.bending_stiffness = 0.44;
    cable_request_.linear_density = 0.064;
    cable_request_.options.timeout = ros::Duration(20.0);
  }

  // The node is alive, and what was asked before has not changed its answers.
  void TearDown() override {
    const auto answer = node_.inverse(inverse_request_);
    EXPECT_EQ(answer.report.code, SolveReport::CONVERGED) << answer.report.message;
  }

  NodeClient node_{"/cogiro"};
  NodeClient point_mass_{"/paper_point_mass"};
  ForwardKinetostatics::Request forward_request_;
  InverseKinetostatics::Request inverse_request_;
  SolveCable::Request cable_request_;
};

TEST_F(BadRequests, Forward) {
  using Request = ForwardKinetostatics::Request;
  std::vector<Case<ForwardKinetostatics>> cases = {
      {"no lengths", [](Request& r) { r.lengths.clear(); }, {"lengths", "0", "8"}},
      {"too few lengths", [](Request& r) { r.lengths.pop_back(); }, {"lengths", "7", "8", "cable0"}},
      {"too many lengths", [](Request& r) { r.lengths.push_back(1.0); }, {"lengths", "9", "8"}},
      {"length NaN", [](Request& r) { r.lengths[2] = kNan; }, {"lengths[2]", "cable2", "nan"}},
      {"length infinite", [](Request& r) { r.lengths[0] = kInfinity; }, {"lengths[0]", "inf"}},
      {"length zero", [](Request& r) { r.lengths[7] = 0.0; }, {"lengths[7]", "cable7", "0 m"}},
      {"length negative", [](Request& r) { r.lengths[1] = -5.0; }, {"lengths[1]", "-5"}},
      {"absurd length", [](Request& r) { r.lengths[1] = 1e7; }, {"lengths[1]", "10000000"}},
      {"fewer names than lengths", [](Request& r) { r.cable_names = {"cable0"}; }, {"cable_names", "1", "8"}},
      {"unknown name",
       [](Request& r) {
         r.cable_names = {"cable0", "cable1", "cable2", "rope", "cable4", "cable5", "cable6", "cable7"};
       },
       {"cable_names[3]", "'rope'", "cable3"},
       SolveReport::UNKNOWN_CABLE},
      {"name twice",
       [](Request& r) {
         r.cable_names = {"cable0", "cable1", "cable2", "cable0", "cable4", "cable5", "cable6", "cable7"};
       },
       {"cable_names[3]", "'cable0'"}},
      {"length NaN under another name",
       [](Request& r) {
         r.cable_names = {"cable7", "cable6", "cable5", "cable4", "cable3", "cable2", "cable1", "cable0"};
         r.lengths[2] = kNan;
       },
       {"lengths[2]", "cable5", "nan"}},
      {"seed without rotation",
       [](Request& r) {
         r.use_seed = true;
         r.seed.position.z = 1.5;
       },
       {"seed.orientation", "(0, 0, 0, 1)"}},
      {"seed NaN",
       [](Request& r) {
         r.use_seed = true;
         r.seed.position.z = kNan;
         r.seed.orientation.w = 1.0;
       },
       {"seed.position.z", "nan"}},
  };
  for (const auto& wrong : wrongOptions<ForwardKinetostatics>()) cases.push_back(wrong);
  for (const auto& wrong : wrongWrenches<ForwardKinetostatics>()) cases.push_back(wrong);
  for (const auto& wrong : cases) {
    expectRefused(wrong, forward_request_, [this](const Request& request) { return node_.forward(request); });
  }
}

TEST_F(BadRequests, Inverse) {
  using Request = InverseKinetostatics::Request;
  std::vector<Case<InverseKinetostatics>> cases = {
      {"no rotation", [](Request& r) { r.pose.orientation.w = 0.0; }, {"pose.orientation", "norm 0"}},
      {"quaternion of norm 1.1", [](Request& r) { r.pose.orientation.w = 1.1; }, {"pose.orientation", "1.1"}},
      {"quaternion NaN", [](Request& r) { r.pose.orientation.x = kNan; }, {"pose.orientation", "nan"}},
      {"quaternion infinite", [](Request& r) { r.pose.orientation.x = kInfinity; }, {"pose.orientation", "inf"}},
      {"position NaN", [](Request& r) { r.pose.position.y = kNan; }, {"pose.position.y", "nan"}},
      {"absurd position", [](Request& r) { r.pose.position.x = 1e9; }, {"pose.position.x", "1000000000"}},
      {"one preferred tension", [](Request& r) { r.preferred_tensions = {100.0}; }, {"preferred_tensions", "1", "8"}},
      {"preferred tension NaN",
       [](Request& r) {
         r.preferred_tensions.assign(8, 500.0);
         r.preferred_tensions[4] = kNan;
       },
       {"preferred_tensions[4]", "cable4", "nan"}},
      {"preferred tension negative",
       [](Request& r) {
         r.preferred_tensions.assign(8, 500.0);
         r.preferred_tensions[0] = -1.0;
       },
       {"preferred_tensions[0]", "-1"}},
      {"out of reach", [](Request& r) { r.pose.position.z = 50.0; }, {}, SolveReport::INFEASIBLE},
  };
  for (const auto& wrong : wrongOptions<InverseKinetostatics>()) cases.push_back(wrong);
  for (const auto& wrong : wrongWrenches<InverseKinetostatics>()) cases.push_back(wrong);
  for (const auto& wrong : cases) {
    expectRefused(wrong, inverse_request_, [this](const Request& request) { return node_.inverse(request); });
  }
}

TEST_F(BadRequests, Cable) {
  using Request = SolveCable::Request;
  std::vector<Case<SolveCable>> cases = {
      {"no problem", [](Request& r) { r.problem = 0; }, {"problem", "0", "FIND_FORCES"}},
      {"no such problem", [](Request& r) { r.problem = 9; }, {"problem", "9"}},
      {"x negative", [](Request& r) { r.x = -1.0; }, {"x is -1"}},
      {"x NaN", [](Request& r) { r.x = kNan; }, {"x is nan"}},
      {"y infinite", [](Request& r) { r.y = -kInfinity; }, {"y is -inf"}},
      {"length zero", [](Request& r) { r.length = 0.0; }, {"length is 0"}},
      {"length absurd", [](Request& r) { r.length = 1e300; }, {"length is 1e+300"}},
      {"no stiffness", [](Request& r) { r.axial_stiffness = 0.0; }, {"axial_stiffness is 0", "inextensible"}},
      {"stiffness negative", [](Request& r) { r.axial_stiffness = -1.0; }, {"axial_stiffness is -1"}},
      {"stiffness infinite", [](Request& r) { r.axial_stiffness = kInfinity; }, {"axial_stiffness is inf"}},
      {"bending negative", [](Request& r) { r.bending_stiffness = -0.1; }, {"bending_stiffness is -0.1"}},
      {"density NaN", [](Request& r) { r.linear_density = kNan; }, {"linear_density is nan"}},
      {"unknown cable",
       [](Request& r) { r.cable_name = "rope"; },
       {"cable_name", "'rope'", "cable0"},
       SolveReport::UNKNOWN_CABLE},
      {"horizontal force NaN",
       [](Request& r) {
         r.problem = Request::FIND_POSITION;
         r.horizontal_force = kNan;
       },
       {"horizontal_force is nan"}},
      {"vertical force absurd",
       [](Request& r) {
         r.problem = Request::FIND_POSITION;
         r.horizontal_force = 100.0;
         r.vertical_force_a = 1e15;
       },
       {"vertical_force_a is 1e+15"}},
      {"tension zero", [](Request& r) { r.problem = Request::FIND_LENGTH; }, {"tension_a is 0"}},
      {"no chord",
       [](Request& r) {
         r.problem = Request::FIND_LENGTH;
         r.x = r.y = 0.0;
         r.tension_a = 100.0;
       },
       {"x and y are both 0"}},
      {"tension too low to hold the cable",
       [](Request& r) {
         r.problem = Request::FIND_LENGTH;
         r.tension_a = 1e-3;
       },
       {},
       SolveReport::INFEASIBLE},
  };
  for (const auto& wrong : wrongOptions<SolveCable>()) cases.push_back(wrong);
  for (const auto& wrong : cases) {
    expectRefused(wrong, cable_request_, [this](const Request& request) { return node_.cable(request); });
  }
}

TEST_F(BadRequests, PointMassTakesNoTorque) {
  const RobotDescription robot = loadRobotFile(ROBOT_DIR "/paper_point_mass.yaml").robot;
  InverseKinetostatics::Request inverse;
  inverse.pose = toMsg(robot.home);
  inverse.external_wrench.torque.y = 2.0;
  const auto inverse_answer = point_mass_.inverse(inverse);
  EXPECT_EQ(inverse_answer.report.code, SolveReport::INVALID_INPUT);
  EXPECT_NE(inverse_answer.report.message.find("external_wrench.torque is (0, 2, 0)"), std::string::npos)
      << inverse_answer.report.message;

  ForwardKinetostatics::Request forward;
  forward.lengths = {4.0, 7.0};
  forward.external_wrench.torque.x = -1.0;
  EXPECT_EQ(point_mass_.forward(forward).report.code, SolveReport::INVALID_INPUT);
}

TEST_F(BadRequests, SlightlyUnnormalisedQuaternionsAreFine) {
  inverse_request_.pose.orientation.w = 1.0009;
  const auto answer = node_.inverse(inverse_request_);
  EXPECT_EQ(answer.report.code, SolveReport::CONVERGED) << answer.report.message;
  const auto& q = answer.pose.orientation;
  EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0, 1e-12);
}

TEST_F(BadRequests, TimeoutIsKept) {
  inverse_request_.options.timeout = ros::Duration(0, 1);
  const auto answer = node_.inverse(inverse_request_);
  EXPECT_EQ(answer.report.code, SolveReport::TIMED_OUT) << answer.report.message;
  EXPECT_TRUE(isFinite(answer));
  inverse_request_.options.timeout = ros::Duration(20.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ros_bad_requests_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

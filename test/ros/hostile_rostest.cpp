// Whatever a client sends, on every service and topic: each request is answered by a known code, a sentence and finite
// numbers, and at the end the node is the same process, as small as before, with the same answers.

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include "cdpr_kinetostatics/KinetostaticState.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "hostile_requests.h"
#include "node_api.h"
#include "node_client.h"

namespace cdpr_kinetostatics {
namespace {

constexpr const char* kNode = "/cogiro";
constexpr double kTimeout = 0.01;     // of a solve [s]
constexpr double kMostGrowth = 64.0;  // [MiB]
constexpr int kWarmUp = 100;          // requests, after which all threads have what they need

class Hostile : public testing::Test {
 protected:
  Hostile() {
    ros::NodeHandle handle;
    measurements_ = handle.advertise<sensor_msgs::JointState>("cable_states", 100);
    const boost::function<void(const KinetostaticState&)> on_state = [this](const KinetostaticState& state) {
      ++states_;
      EXPECT_TRUE(allFinite(state.report) && allFinite(state.pose.pose) && allFinite(state.cables)) << state;
      expectOutcome(state.report);
    };
    state_ = handle.subscribe<KinetostaticState>("kinetostatic_state", 1000, on_state);
  }

  static void expectOutcome(const SolveReport& report) {
    EXPECT_TRUE(report.code == SolveReport::CONVERGED || report.code < SolveReport::UNSET) << report.code;
    EXPECT_NE(report.code, SolveReport::INTERNAL_ERROR) << report.message;
    EXPECT_TRUE(report.code == SolveReport::CONVERGED || !report.message.empty()) << report.code;
  }

  template <typename Service>
  void ask(ros::ServiceClient& client, typename Service::Request request) {
    SCOPED_TRACE(testing::Message() << request);
    typename Service::Response response;
    ASSERT_TRUE(client.call(request, response)) << client.getService() << " did not answer";
    EXPECT_TRUE(isFinite(response)) << response;
    expectOutcome(response.report);
  }

  void sendOne() {
    switch (requests_.integer(0, 5)) {
      case 0:
        return ask<ForwardKinetostatics>(forward_, requests_.forward());
      case 1:
        return ask<InverseKinetostatics>(inverse_, requests_.inverse());
      case 2:
        return ask<SolveCable>(cable_, requests_.cable());
      case 3: {
        SetPose set_pose;
        set_pose.request = requests_.setPose();
        ASSERT_TRUE(set_pose_.call(set_pose)) << set_pose.request;
        EXPECT_TRUE(set_pose.response.success || !set_pose.response.message.empty());
        return;
      }
      case 4: {
        std_srvs::Trigger reset;
        ASSERT_TRUE(reset_.call(reset));
        EXPECT_TRUE(reset.response.success);
        return;
      }
      default:
        measurements_.publish(requests_.measurements(ros::Time::now()));
    }
  }

  InverseKinetostatics::Response sensible() {
    InverseKinetostatics::Request request;
    request.pose = toMsg(robot_.home);
    request.options.timeout = ros::Duration(20.0);
    return NodeClient(kNode).inverse(request);
  }

  // Waits for it: a persistent connection is made once.
  static std::string service(const char* name) {
    const std::string service = std::string(kNode) + "/" + name;
    EXPECT_TRUE(ros::service::waitForService(service, ros::Duration(60.0)));
    return service;
  }

  const RobotDescription robot_ = loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot;
  HostileRequests requests_{robot_, kTimeout, true, 7};
  ros::ServiceClient forward_ = connect<ForwardKinetostatics>(service("forward_kinetostatics"));
  ros::ServiceClient inverse_ = connect<InverseKinetostatics>(service("inverse_kinetostatics"));
  ros::ServiceClient cable_ = connect<SolveCable>(service("solve_cable"));
  ros::ServiceClient set_pose_ = connect<SetPose>(service("set_pose"));
  ros::ServiceClient reset_ = connect<std_srvs::Trigger>(service("reset"));
  ros::Publisher measurements_;
  ros::Subscriber state_;
  int states_ = 0;
};

TEST_F(Hostile, RequestsAndMessagesAreAnswered) {
  const int count = ros::param::param("~count", 1000);
  const InverseKinetostatics::Response before = sensible();
  ASSERT_EQ(before.report.code, SolveReport::CONVERGED) << before.report.message;
  const int pid = pidOf(kNode);
  ASSERT_GT(pid, 0);
  while (measurements_.getNumSubscribers() == 0 || state_.getNumPublishers() == 0) ros::WallDuration(0.01).sleep();
  double memory = 0.0;
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    if (i == kWarmUp) memory = residentMemory(pid);
    sendOne();
    ros::getGlobalCallbackQueue()->callAvailable();
    ASSERT_EQ(pidOf(kNode), pid) << "the node has died";
    if (HasFatalFailure()) return;
  }
  const double grown = residentMemory(pid) - memory;
  std::cout << count << " requests and messages, " << states_ << " estimates; memory " << memory << " MiB, then "
            << grown << " MiB more\n";
  EXPECT_LT(grown, kMostGrowth);
  EXPECT_GT(states_, 0);
  const InverseKinetostatics::Response after = sensible();
  EXPECT_EQ(after.lengths, before.lengths);
  EXPECT_EQ(after.report.code, before.report.code);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ros_hostile_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

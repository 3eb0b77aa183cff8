// The estimator in the node under everything that sensors and their drivers do: each has its outcome and is told.

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "cdpr_kinetostatics/KinetostaticState.h"
#include "cdpr_kinetostatics/SetPose.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "node_client.h"
#include "ros/conversions.h"
#include "ros/service_reply.h"

namespace cdpr_kinetostatics {
namespace {

class Sensors {
 public:
  Sensors() : robot_(loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot) {
    const boost::function<void(const KinetostaticState&)> on_state = [this](const auto& m) {
      states_[m.header.stamp] = m;
    };
    const boost::function<void(const geometry_msgs::PoseWithCovarianceStamped&)> on_pose = [this](const auto& m) {
      poses_[m.header.stamp] = m.pose.pose;
    };
    const boost::function<void(const diagnostic_msgs::DiagnosticArray&)> on_diagnostics = [this](const auto& m) {
      for (const auto& status : m.status) diagnostics_[status.name] = status.message;
    };
    subscribers_.push_back(handle_.subscribe<KinetostaticState>("kinetostatic_state", 1000, on_state));
    subscribers_.push_back(handle_.subscribe<geometry_msgs::PoseWithCovarianceStamped>("platform_pose", 1000, on_pose));
    subscribers_.push_back(handle_.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1000, on_diagnostics));
    InverseRequest request;
    request.pose = robot_.home;
    request.pose.position += Eigen::Vector3d(0.3, -0.2, 0.1);
    RobotSolverOptions options;
    options.model = Model::kCatenary;
    options.timeout = std::chrono::duration<double>(10.0);
    truth_ = solveInverse(robot_, request, options);
  }

  bool waitFor(const std::function<bool()>& condition) {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(30.0);
    while (!condition() && ros::WallTime::now() < deadline) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
    }
    return condition();
  }

  void connect() {
    publisher_ = handle_.advertise<sensor_msgs::JointState>("cable_states", 1000);
    ASSERT_TRUE(waitFor([&] { return publisher_.getNumSubscribers() > 0; }));
    for (auto& subscriber : subscribers_) {
      ASSERT_TRUE(waitFor([&] { return subscriber.getNumPublishers() > 0; }));
    }
  }

  sensor_msgs::JointState message() const {
    sensor_msgs::JointState m;
    m.header.stamp = ros::Time::now();
    for (const CableResult& cable : truth_.cables) {
      m.name.push_back(cable.name);
      m.position.push_back(cable.cable.length);
      m.effort.push_back(cable.cable.tension_a);
    }
    return m;
  }

  void send(const sensor_msgs::JointState& m) { publisher_.publish(m); }

  KinetostaticState stateAfter(const sensor_msgs::JointState& m) {
    send(m);
    EXPECT_TRUE(waitFor([&] { return states_.count(m.header.stamp) > 0; })) << "no state for a message";
    return states_[m.header.stamp];
  }

  void expectTruth(const KinetostaticState& state) {
    ASSERT_EQ(state.report.code, SolveReport::CONVERGED) << state.report.message;
    EXPECT_LT((fromMsg(state.pose.pose).position - truth_.pose.position).norm(), 1e-6);
    EXPECT_TRUE(waitFor([&] { return poses_.count(state.header.stamp) > 0; })) << "no pose for a good state";
    EXPECT_EQ(state.header.frame_id, "world");
  }

  // A good message still gives the truth.
  void expectRecovery() { expectTruth(stateAfter(message())); }

  void expectDiagnostics(const std::string& task, const std::string& words) {
    EXPECT_TRUE(waitFor([&] { return diagnostics_["kinetostatics: " + task].find(words) != std::string::npos; }))
        << "'" << words << "' is not what diagnostics say: " << diagnostics_["kinetostatics: " + task];
  }

  bool hasPose(const ros::Time& stamp) const { return poses_.count(stamp) > 0; }
  bool hasState(const ros::Time& stamp) const { return states_.count(stamp) > 0; }

 private:
  ros::NodeHandle handle_;
  RobotDescription robot_;
  RobotSolution truth_;
  ros::Publisher publisher_;
  std::vector<ros::Subscriber> subscribers_;
  std::map<ros::Time, KinetostaticState> states_;
  std::map<ros::Time, geometry_msgs::Pose> poses_;
  std::map<std::string, std::string> diagnostics_;
};

class Estimator : public testing::Test {
 protected:
  static void SetUpTestSuite() { sensors_ = new Sensors; }
  static void TearDownTestSuite() { delete sensors_; }

  // Sent again and again until diagnostics say so: they tell of the last period alone.
  static void expectRefusal(const std::function<void(sensor_msgs::JointState&)>& spoil, const std::string& words) {
    sensor_msgs::JointState m = sensors_->message();
    spoil(m);
    sensors_->send(m);
    sensors_->expectDiagnostics("input", words);
    sensors_->expectRecovery();
    EXPECT_FALSE(sensors_->hasState(m.header.stamp));
  }

  static Sensors* sensors_;
};
Sensors* Estimator::sensors_ = nullptr;

TEST_F(Estimator, SaysWhatItWaitsFor) {
  sensors_->expectDiagnostics("input", "waiting for /cable_states: nothing received; publishers on that topic: 0");
  sensors_->connect();
  sensors_->expectDiagnostics("input", "publishers on that topic: 1");
}

TEST_F(Estimator, StartsColdAndGoesOnWarm) {
  const KinetostaticState first = sensors_->stateAfter(sensors_->message());
  sensors_->expectTruth(first);
  EXPECT_FALSE(first.report.warm_started);
  ASSERT_EQ(first.cables.size(), 8u);
  EXPECT_EQ(first.cables[3].profile.size(), 21u);
  EXPECT_EQ(first.tension_residual.size(), 8u);
  const KinetostaticState second = sensors_->stateAfter(sensors_->message());
  EXPECT_TRUE(second.report.warm_started);
  sensors_->expectDiagnostics("estimate", "measurements agree");
}

TEST_F(Estimator, FlagsAStuckCell) {
  sensor_msgs::JointState m = sensors_->message();
  m.effort[2] += 300.0;
  const KinetostaticState state = sensors_->stateAfter(m);
  ASSERT_EQ(state.outlier.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(state.outlier[i], i == 2) << i;
  sensors_->expectTruth(state);
  sensors_->expectDiagnostics("estimate", "tension of cable2");
  sensors_->expectRecovery();
  sensors_->expectDiagnostics("estimate", "measurements agree");
}

TEST_F(Estimator, FlagsALengthOffByATurnOfTheDrum) {
  sensor_msgs::JointState m = sensors_->message();
  m.position[5] += 0.3;
  const KinetostaticState state = sensors_->stateAfter(m);
  EXPECT_TRUE(state.outlier[5]);
  sensors_->expectTruth(state);
  sensors_->expectRecovery();
}

TEST_F(Estimator, DoesWithoutSomeMeasurements) {
  sensor_msgs::JointState m = sensors_->message();
  m.position[0] = m.effort[4] = std::nan("");
  sensors_->expectTruth(sensors_->stateAfter(m));
  m = sensors_->message();
  m.effort.clear();
  const KinetostaticState lengths_only = sensors_->stateAfter(m);
  sensors_->expectTruth(lengths_only);
  EXPECT_TRUE(lengths_only.tension_residual.empty());
}

TEST_F(Estimator, PublishesNoPoseWithoutMeasurements) {
  sensor_msgs::JointState m = sensors_->message();
  for (std::size_t i = 0; i < 8; ++i) m.position[i] = m.effort[i] = std::nan("");
  const KinetostaticState state = sensors_->stateAfter(m);
  if (state.report.code == SolveReport::CONVERGED) {
    EXPECT_EQ(state.pose.covariance[0], 1e6) << "nothing is measured: nothing is known";
  } else {
    EXPECT_FALSE(state.report.message.empty());
    EXPECT_TRUE(allFinite(state.pose.pose));
    sensors_->expectRecovery();
    EXPECT_FALSE(sensors_->hasPose(m.header.stamp));
  }
  sensors_->expectRecovery();
}

TEST_F(Estimator, RefusesMessagesOfTheWrongShape) {
  expectRefusal([](auto& m) { m.position.pop_back(); }, "position has 7 entries");
  expectRefusal([](auto& m) { m.effort.push_back(1.0); }, "effort has 9 entries");
  expectRefusal([](auto& m) { m.name[1] = "cable0"; }, "'cable0' more than once");
  expectRefusal(
      [](auto& m) {
        for (std::string& name : m.name) name = "x" + name;
      },
      "none of the names");
}

TEST_F(Estimator, RefusesMessagesOfTheWrongTime) {
  expectRefusal([](auto& m) { m.header.stamp -= ros::Duration(10.0); }, "s ago");
  expectRefusal([](auto& m) { m.header.stamp += ros::Duration(10.0); }, "in the future");
  expectRefusal([](auto& m) { m.header.stamp = ros::Time(std::numeric_limits<std::uint32_t>::max(), 0); },
                "in the future");
  expectRefusal([](auto& m) { m.header.stamp = ros::Time(); }, "header.stamp is 0");
}

// The node's marker_rate is one in 300 years.
TEST_F(Estimator, ShowsMarkersAtAnyRate) {
  int shown = 0;
  const boost::function<void(const visualization_msgs::MarkerArray&)> on_markers = [&](const auto&) { ++shown; };
  ros::NodeHandle handle;
  const ros::Subscriber markers = handle.subscribe<visualization_msgs::MarkerArray>("cable_markers", 10, on_markers);
  ASSERT_TRUE(sensors_->waitFor([&] { return markers.getNumPublishers() > 0; }));
  EXPECT_TRUE(sensors_->waitFor([&] {
    sensors_->expectRecovery();
    return shown > 0;
  }));
  for (int k = 0; k < 3; ++k) sensors_->expectRecovery();
  EXPECT_EQ(shown, 1);
}

TEST_F(Estimator, StartsAnewWhenTimeGoesBack) {
  sensor_msgs::JointState m = sensors_->message();
  m.header.stamp += ros::Duration(1.5);
  sensors_->expectTruth(sensors_->stateAfter(m));
  m.header.stamp -= ros::Duration(2.5);
  const KinetostaticState after = sensors_->stateAfter(m);
  EXPECT_FALSE(after.report.warm_started);
  sensors_->expectTruth(after);
}

TEST_F(Estimator, CanBeResetAndSeeded) {
  sensors_->expectRecovery();
  std_srvs::Trigger reset;
  ASSERT_TRUE(connect<std_srvs::Trigger>("/kinetostatics/reset").call(reset));
  EXPECT_TRUE(reset.response.success);
  EXPECT_FALSE(sensors_->stateAfter(sensors_->message()).report.warm_started);
  SetPose seed;
  seed.request.pose.pose.position.z = 1.4;
  ASSERT_TRUE(connect<SetPose>("/kinetostatics/set_pose").call(seed));
  EXPECT_FALSE(seed.response.success) << "the quaternion is 0";
  EXPECT_NE(seed.response.message.find("orientation"), std::string::npos);
  seed.request.pose.pose.orientation.w = 1.0;
  ASSERT_TRUE(connect<SetPose>("/kinetostatics/set_pose").call(seed));
  EXPECT_TRUE(seed.response.success) << seed.response.message;
  const KinetostaticState state = sensors_->stateAfter(sensors_->message());
  EXPECT_FALSE(state.report.warm_started);
  sensors_->expectTruth(state);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ros_estimator_rostest");
  ros::NodeHandle handle;
  return RUN_ALL_TESTS();
}

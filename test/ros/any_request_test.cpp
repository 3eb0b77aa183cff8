// Whatever numbers a request holds, it is answered in time, with a code, a sentence and finite numbers.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "node_client.h"
#include "ros/cable_service.h"
#include "ros/conversions.h"
#include "ros/forward_service.h"
#include "ros/inverse_service.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kRequests = 300;
constexpr double kTimeout = 0.02;  // [s]
// How much later than the timeout an answer may come [s]: a step of the solver, on a busy machine with sanitizers.
constexpr double kGrace = 1.0;

// Requests are drawn around a sensible one, a few of their numbers replaced by unlikely ones.
class AnyRequest : public testing::TestWithParam<const char*> {
 protected:
  AnyRequest() { parameters_.robot = loadRobotFile(std::string(ROBOT_DIR) + "/" + GetParam() + ".yaml").robot; }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  double near(double value) {
    static const double kUnlikely[] = {
        0.0,         -0.0, 1e-300, -1e-12, 1e-9,  1e-3, -1.0,  1e3,    -1e3,
        1e6,         -1e6, 1e9,    1e12,   -1e12, 1e13, 1e300, -1e300, std::numeric_limits<double>::infinity(),
        std::nan("")};
    if (integer(0, 9) > 0) return value * uniform(0.9, 1.1);
    return kUnlikely[integer(0, static_cast<int>(std::size(kUnlikely)) - 1)];
  }

  SolverOptions options() {
    SolverOptions options;
    options.model = static_cast<std::uint8_t>(integer(0, 9));
    options.tolerance = near(1e-8);
    options.timeout = ros::Duration(kTimeout);
    return options;
  }

  geometry_msgs::Pose pose() {
    geometry_msgs::Pose pose = toMsg(parameters_.robot.home);
    pose.position.x = near(pose.position.x + 0.1 * uniform(-1.0, 1.0) * parameters_.robot.span());
    pose.position.y = near(pose.position.y + 0.1 * uniform(-1.0, 1.0) * parameters_.robot.span());
    pose.position.z = near(pose.position.z);
    return pose;
  }

  geometry_msgs::Wrench wrench() {
    geometry_msgs::Wrench wrench;
    wrench.force.x = near(0.1 * parameters_.robot.weight());
    wrench.force.z = near(0.1 * parameters_.robot.weight());
    return wrench;
  }

  template <typename Response>
  void expectAnswer(const Response& response, std::uint8_t model, std::chrono::steady_clock::time_point start) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), kTimeout + kGrace);
    EXPECT_TRUE(isFinite(response));
    EXPECT_NE(response.report.code, SolveReport::UNSET);
    EXPECT_NE(response.report.code, SolveReport::INTERNAL_ERROR) << response.report.message;
    // A solved request has something to say only where the node chose the models, as it does by default.
    const bool chosen = model == SolverOptions::AUTO || model == SolverOptions::MODEL_DEFAULT;
    EXPECT_EQ(response.report.message.empty(), response.report.code == SolveReport::CONVERGED && !chosen);
  }

  NodeParameters parameters_;
  std::mt19937 random_{1};
};

TEST_P(AnyRequest, Forward) {
  for (int i = 0; i < kRequests; ++i) {
    ForwardKinetostatics::Request request;
    for (const CableDescription& cable : parameters_.robot.cables) {
      const Eigen::Vector3d end = parameters_.robot.home.transform(cable.attachment);
      const double chord = (end - cable.anchor).norm();
      request.lengths.push_back(integer(0, 3) == 0 ? near(chord) : chord * uniform(0.98, 1.02));
    }
    request.external_wrench = wrench();
    request.use_seed = integer(0, 1) == 1;
    request.seed = pose();
    request.options = options();
    request.profile_points = 5 * integer(0, 1);
    request.compute_stiffness = integer(0, 1) == 1;
    SCOPED_TRACE(testing::Message() << "request " << i << "\n" << request);
    const auto start = std::chrono::steady_clock::now();
    expectAnswer(serveForward(parameters_, request), request.options.model, start);
  }
}

TEST_P(AnyRequest, Inverse) {
  for (int i = 0; i < kRequests; ++i) {
    InverseKinetostatics::Request request;
    request.pose = pose();
    request.free_orientation = integer(0, 1) == 1;
    request.external_wrench = wrench();
    if (integer(0, 1) == 1) {
      for (const CableDescription& cable : parameters_.robot.cables) {
        request.preferred_tensions.push_back(near(2.0 * cable.tension_min));
      }
    }
    request.options = options();
    request.profile_points = 5 * integer(0, 1);
    SCOPED_TRACE(testing::Message() << "request " << i << "\n" << request);
    const auto start = std::chrono::steady_clock::now();
    expectAnswer(serveInverse(parameters_, request), request.options.model, start);
  }
}

TEST_P(AnyRequest, Cable) {
  const CableProperties& properties = parameters_.robot.cables[0].properties;
  for (int i = 0; i < 2 * kRequests; ++i) {
    SolveCable::Request request;
    request.problem = static_cast<std::uint8_t>(integer(1, 3));
    request.x = near(8.0);
    request.y = near(-4.0);
    request.length = near(9.0);
    request.horizontal_force = near(300.0);
    request.vertical_force_a = near(200.0);
    request.tension_a = near(400.0);
    if (integer(0, 1) == 1) request.cable_name = parameters_.robot.cables[0].name;
    request.axial_stiffness = near(properties.axial_stiffness);
    request.bending_stiffness = near(properties.bending_stiffness);
    request.linear_density = near(properties.weight / parameters_.robot.gravity);
    request.options = options();
    request.profile_points = 5 * integer(0, 1);
    SCOPED_TRACE(testing::Message() << "request " << i << "\n" << request);
    const auto start = std::chrono::steady_clock::now();
    expectAnswer(serveCable(parameters_, request), request.options.model, start);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, AnyRequest, testing::Values("cogiro", "scampi", "paper_point_mass"),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace cdpr_kinetostatics
